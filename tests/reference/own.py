"""What a case file says of single courses, joints and blocks, by other code than the program's.

A body is its place among the blocks, or -1 less its place among the supports; of a coursed wall the ground is -1.
"""
import bonds


def live_of_weight(file):
    """What every weight pushes with, along the push and upwards."""
    live = file.get("live", "weight")
    return live["weight"] if isinstance(live, dict) else {"weight": (1.0, 0.0), "loads": (0.0, 0.0)}[live]


def levels(file):
    """Heights of the beds of a wall's courses and of its top."""
    rows, out = bonds.rows(file), [0.0]
    heights = file.get("heights", [file["unit"]["height"]])
    for row in range(len(rows)):
        out.append(out[-1] + heights[row % len(heights)])
    return out


class Own:
    def __init__(self, file):
        self.classes = file["friction"] if isinstance(file["friction"], dict) else {"bed": file["friction"]}
        tables = file.get("joint", []) + file.get("joints", [])
        self.beds = {table["course"]: table["friction"] for table in tables if "course" in table}
        self.open_courses = set(file.get("open_head_joints", []))
        self.courses, places, names = [], {}, []
        if "unit" in file:
            for row, course in enumerate(bonds.rows(file), 1):
                for piece, (kind, _) in enumerate(course, 1):
                    if kind != "g":
                        places[row, piece] = len(names)
                        names.append(f"course {row} piece {piece}")
                        self.courses.append(row)
            supports = ["ground"]
        elif "arch" in file:
            names, supports = [str(k + 1) for k in range(file["arch"]["voussoirs"])], ["left", "right"]
        else:
            names = [body["name"] for body in file.get("block", []) if "corners" in body]
            supports = [body["name"] for body in file.get("support", [])]
        self.tables = {}
        for table in file.get("block", []):
            place = places[table["course"], table["piece"]] if "course" in table else names.index(table["name"])
            self.tables[place] = table
            names[place] = table.get("name", names[place])
        self.places = {name: place for place, name in enumerate(names)}
        bodies = {**{name: -1 - place for place, name in enumerate(supports)}, **self.places}
        self.named = {tuple(sorted(bodies[name] for name in table["between"])): table
                      for table in tables if "between" in table}

    def joint(self, first, second, kind):
        """Class, coefficient of friction and whether it is open of the joint of two bodies, from its class by slope."""
        table = self.named.get((min(first, second), max(first, second)), {})
        kind = table.get("class", kind)
        of_class = self.classes.get(kind, self.classes["bed"])
        rough = min(self.tables.get(body, {}).get("friction", of_class) for body in (first, second))
        course = self.courses[max(first, second)] if self.courses else None
        if kind != "head" and course in self.beds:
            rough = self.beds[course]
        is_open = kind == "head" and (table.get("open", False) or course in self.open_courses)
        return kind, table.get("friction", rough), is_open
