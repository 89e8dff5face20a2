//! The script of `trilith sweep FILE --slurm N`.

use std::path::{Path, absolute};

use super::stop::Stop;

/// A script that submits a job array of the shards and a merge that waits for all of them.
pub(super) fn script(
    file: &str,
    name: &str,
    folder: &Path,
    external: &[String],
    shards: u64,
) -> Result<String, Stop> {
    let failed = |e: std::io::Error| Stop::bad_input(format!("error: no path for the script: {e}"));
    let program = std::env::current_exe().map_err(failed)?;
    // A job begins in the folder that it was submitted from, which may be another one.
    let file = if Path::new(file).is_file() {
        absolute(file).map_err(failed)?.display().to_string()
    } else {
        file.to_owned()
    };
    let folder = absolute(folder).map_err(failed)?.display().to_string();
    let program = program.display().to_string();
    let [program, file, folder] = [program, file, folder].map(|text| quoted(&text));
    let external = external.iter();
    let external = external.map(|argument| format!(" --external {}", quoted(argument)));
    let external: String = external.collect();
    Ok(SCRIPT
        .replace("@NAME", name)
        .replace("@SHARDS", &shards.to_string())
        .replace("@PROGRAM", &program)
        .replace("@FILE", &file)
        .replace("@FOLDER", &folder)
        .replace("@EXTERNAL", &external))
}

fn quoted(text: &str) -> String {
    format!("'{}'", text.replace('\'', r"'\''"))
}

/// A shard whose rows hold a failed result ends with 1 and is complete all the same.
const SCRIPT: &str = r#"#!/bin/sh
# Runs the sweep @NAME in @SHARDS shards on Slurm and merges them: sh THIS-FILE
# Partition, account and time come from SBATCH_PARTITION, SBATCH_ACCOUNT and SBATCH_TIMELIMIT.
# Submitted again it repeats nothing that is finished.
set -eu
folder=@FOLDER
mkdir -p "$folder"
shards=$(sbatch --parsable --job-name=@NAME --array=1-@SHARDS --output="$folder/slurm-%A-%a.log" <<'JOB'
#!/bin/sh
export RAYON_NUM_THREADS="${SLURM_CPUS_PER_TASK:-1}"
@PROGRAM sweep @FILE --out @FOLDER --shard "$SLURM_ARRAY_TASK_ID/@SHARDS"@EXTERNAL || [ $? -eq 1 ]
JOB
)
merge=$(sbatch --parsable --job-name=@NAME-merge --dependency="afterok:${shards%%;*}" \
  --kill-on-invalid-dep=yes --output="$folder/slurm-%j.log" <<'JOB'
#!/bin/sh
@PROGRAM merge @FILE --out @FOLDER@EXTERNAL
JOB
)
echo "shards: job ${shards%%;*}, merge: job ${merge%%;*}, results: $folder/sweep.csv"
"#;
