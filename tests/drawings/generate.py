"""Writes the drawings of this folder with ezdxf (python3 -m pip install ezdxf==1.4.5):

    tests/drawings/generate.py FOLDER

One wall in R12, 2000, 2007 and 2018, as lines, INSERTs and in metres; noise of 1e-6 to 1e-3 of a block; arches of
bulges and of arcs; and drawings that are to be refused. The tests need only the files that are kept here.
"""
import math, random, sys, pathlib
import ezdxf
from ezdxf.enums import InsertUnits
out=pathlib.Path(sys.argv[1]); out.mkdir(exist_ok=True,parents=True)
def rect(x,y,w,h): return [(x,y),(x+w,y),(x+w,y+h),(x,y+h)]
def wall(courses=4, units=3, L=500.0, H=250.0):
    """running bond in mm"""
    bl=[]
    for c in range(courses):
        x=0.0; y=c*H
        ws=[L]*units if c%2==0 else [L/2]+[L]*(units-1)+[L/2]
        for w in ws:
            bl.append(rect(x,y,w,H)); x+=w
    return bl
ground=rect(-1000,-250,3500,250)
def doc(v,units=4):
    d=ezdxf.new(v, setup=False)
    try: d.header['$INSUNITS']=units
    except Exception: pass
    for l in ('stones','support','notes'): d.layers.add(l)
    return d
def noisy(pts,a,rng): return [(x+rng.uniform(-a,a),y+rng.uniform(-a,a)) for x,y in pts]
# versions, closed polylines
for v in ('R12','R2000','R2007','R2018'):
    d=doc(v); m=d.modelspace()
    for b in wall():
        if v=='R12': m.add_polyline2d(b,close=True,dxfattribs={'layer':'stones'})
        else: m.add_lwpolyline(b,close=True,dxfattribs={'layer':'stones'})
    (m.add_polyline2d if v=='R12' else m.add_lwpolyline)(ground,close=True,dxfattribs={'layer':'support'})
    m.add_text('a wall',dxfattribs={'layer':'notes'})
    d.saveas(out/f'wall-{v}.dxf')
# lines
d=doc('R2010'); m=d.modelspace()
for b in wall()+[ground]:
    lay='support' if b is ground else 'stones'
    for p,q in zip(b,b[1:]+b[:1]): m.add_line(p,q,dxfattribs={'layer':lay})
d.saveas(out/'wall-lines.dxf')
# equal ends, metres
d=doc('R2010',6); m=d.modelspace()
for b in wall(): m.add_lwpolyline([(x/1000,y/1000) for x,y in b+b[:1]],dxfattribs={'layer':'stones'})
m.add_lwpolyline([(x/1000,y/1000) for x,y in ground],close=True,dxfattribs={'layer':'ground'})
d.saveas(out/'wall-metres.dxf')
# blocks (INSERT), scaled, rotated group
d=doc('R2010'); m=d.modelspace()
b=d.blocks.new('UNIT'); b.add_lwpolyline(rect(0,0,1,1),close=True)
for r in wall():
    (x,y),(x2,y2)=r[0],r[2]
    m.add_blockref('UNIT',(x,y),dxfattribs={'layer':'stones','xscale':x2-x,'yscale':y2-y})
m.add_lwpolyline(ground,close=True,dxfattribs={'layer':'support'})
d.saveas(out/'wall-inserts.dxf')
# INSERT array: stack of 3 x 2, mirrored
d=doc('R2010'); m=d.modelspace()
b=d.blocks.new('PIER'); b.add_lwpolyline(rect(0,0,400,300),close=True)
m.add_blockref('PIER',(400,0),dxfattribs={'layer':'stones','xscale':-1,'row_count':5,'row_spacing':300})
m.add_lwpolyline(ground,close=True,dxfattribs={'layer':'support'})
d.saveas(out/'pier-array.dxf')
# noise
for e in (1e-6,1e-5,1e-4,1e-3):
    rng=random.Random(7)
    d=doc('R2010'); m=d.modelspace()
    for b in wall(8,4): m.add_lwpolyline(noisy(b,e*500,rng),close=True,dxfattribs={'layer':'stones'})
    m.add_lwpolyline(rect(-1000,-250,4000,250),close=True,dxfattribs={'layer':'support'})
    d.saveas(out/f'noise-{e:.0e}.dxf')
# arch with bulges: semicircle 15 voussoirs, mean radius 10, t 1.5 (drawn in metres)
def arch(n,R,t,noise=0,seed=3):
    d=doc('R2010',6); m=d.modelspace(); rng=random.Random(seed)
    a=lambda k: math.pi-math.pi*k/n
    bulge=math.tan(math.pi/n/4)
    for k in range(n):
        i,o=R-t/2,R+t/2
        p=[(i*math.cos(a(k)),i*math.sin(a(k))),(i*math.cos(a(k+1)),i*math.sin(a(k+1))),(o*math.cos(a(k+1)),o*math.sin(a(k+1))),(o*math.cos(a(k)),o*math.sin(a(k)))]
        if noise: p=noisy(p,noise,rng)
        m.add_lwpolyline([(*p[0],-bulge),(*p[1],0),(*p[2],bulge),(*p[3],0)],format='xyb',close=True,dxfattribs={'layer':'voussoirs'})
    m.add_lwpolyline(rect(-R-2*t,-1,4*t,1),close=True,dxfattribs={'layer':'support'})
    m.add_lwpolyline(rect(R-2*t,-1,4*t,1),close=True,dxfattribs={'layer':'support'})
    return d
arch(15,10,1.5).saveas(out/'arch-bulges.dxf')
arch(15,10,1.5,noise=1e-3).saveas(out/'arch-noise.dxf')
# arch of lines and ARC entities
d=doc('R2010',6); m=d.modelspace(); n,R,t=9,10.0,1.5
for k in range(n):
    i,o=R-t/2,R+t/2; a0,a1=math.pi-math.pi*k/n, math.pi-math.pi*(k+1)/n
    m.add_arc((0,0),i,math.degrees(a1),math.degrees(a0),dxfattribs={'layer':'v'})
    m.add_line((i*math.cos(a1),i*math.sin(a1)),(o*math.cos(a1),o*math.sin(a1)),dxfattribs={'layer':'v'})
    m.add_arc((0,0),o,math.degrees(a1),math.degrees(a0),dxfattribs={'layer':'v'})
    m.add_line((i*math.cos(a0),i*math.sin(a0)),(o*math.cos(a0),o*math.sin(a0)),dxfattribs={'layer':'v'})
for s in (-R-2*t,R-2*t): m.add_lwpolyline(rect(s,-1,4*t,1),close=True,dxfattribs={'layer':'support'})
d.saveas(out/'arch-arcs.dxf')
# refused
def base():
    d=doc('R2010'); m=d.modelspace()
    for b in wall(): m.add_lwpolyline(b,close=True,dxfattribs={'layer':'stones'})
    m.add_lwpolyline(ground,close=True,dxfattribs={'layer':'support'})
    return d,m
d,m=base(); m.add_spline([(0,0),(100,50),(200,0)],dxfattribs={'layer':'stones'}); d.saveas(out/'refused-spline.dxf')
d,m=base(); h=m.add_hatch(dxfattribs={'layer':'fill'}); h.paths.add_polyline_path(rect(0,0,500,250),is_closed=True); d.saveas(out/'refused-hatch.dxf')
d,m=base(); m.add_line((0,1000),(300,1300),dxfattribs={'layer':'stones'}); d.saveas(out/'refused-open.dxf')
d,m=base(); m.add_lwpolyline(rect(0,1020,500,250),close=True,dxfattribs={'layer':'stones'}); d.saveas(out/'refused-gap.dxf')
d,m=base(); m.add_lwpolyline(rect(0,1008,500,250),close=True,dxfattribs={'layer':'stones'}); d.saveas(out/'refused-small-gap.dxf')
d,m=base(); m.add_lwpolyline(rect(0,960,500,250),close=True,dxfattribs={'layer':'stones'}); d.saveas(out/'refused-overlap.dxf')
d,m=base(); m.add_ellipse((0,0),(100,0),0.5,dxfattribs={'layer':'stones'}); d.saveas(out/'refused-ellipse.dxf')
# no layer for support: lowest wide
d=doc('R2010'); m=d.modelspace()
for b in wall()+[ground]: m.add_lwpolyline(b,close=True,dxfattribs={'layer':'0'})
d.saveas(out/'wall-lowest.dxf')
# ring stone: L-shapes & circle
d=doc('R2010'); m=d.modelspace()
m.add_lwpolyline(ground,close=True,dxfattribs={'layer':'support'})
m.add_lwpolyline([(0,0),(600,0),(600,300),(300,300),(300,900),(0,900)],close=True,dxfattribs={'layer':'s'})
m.add_lwpolyline([(300,300),(600,300),(600,900),(300,900)],close=True,dxfattribs={'layer':'s'})
m.add_lwpolyline(rect(0,900,600,200),close=True,dxfattribs={'layer':'s'})
d.saveas(out/'l-shape.dxf')
