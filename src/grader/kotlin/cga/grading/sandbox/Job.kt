package cga.grading.sandbox

import java.nio.file.Path

/**
 * A command to run at arm's length.
 *
 * All paths inside are those outside. Standard input is empty; the working directory is [workingDirectory],
 * which is the scratch folder or one that the job may read, or inside of one.
 *
 * @param command the program and its arguments; the program is looked up in the system's folders.
 * @param scratch an existing folder that the job may fill; nothing else on the disk can be changed. It is also its HOME.
 * @param readOnly what the job may read besides the system's programs and libraries.
 * @param environment all of it: nothing is inherited but for PATH, HOME, TMPDIR and LANG, which are set here.
 */
public class Job(
    public val command: List<String>,
    public val scratch: Path,
    public val readOnly: List<Path> = emptyList(),
    public val environment: Map<String, String> = emptyMap(),
    public val workingDirectory: Path = scratch,
    public val limits: Limits = Limits(),
) {
    init {
        require(command.isNotEmpty()) { "no command" }
        require(
            (readOnly + listOf(scratch)).any {
                workingDirectory.startsWith(it)
            },
        ) { "the job cannot see its working directory $workingDirectory" }
        require(command.none { '\u0000' in it }) { "a NUL character in the command $command" }
    }
}
