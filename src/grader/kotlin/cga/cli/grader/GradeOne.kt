package cga.cli.grader

import cga.framework.Home
import cga.framework.InputError
import cga.framework.reason
import cga.grading.course.GradeOne
import cga.grading.course.NoSandboxError
import cga.grading.pipeline.Pipeline
import cga.grading.prepared.Edition
import cga.grading.sandbox.Sandbox
import java.io.IOException

/** What grades one submission, in a sandbox unless [settings] allow none. Throws [NoSandboxError] where there is no sandbox. */
internal fun gradeOne(settings: PipelineSettings): GradeOne {
    val missing = Sandbox.unavailable.takeUnless { settings.unsafeNoSandbox }
    if (missing != null) throw NoSandboxError(missing)
    val sandbox = if (settings.unsafeNoSandbox) Sandbox.unconfined() else Sandbox.confined()
    val home = Home.resolve("build/cga/grading").toAbsolutePath()
    return try {
        Pipeline(sandbox, settings.edition?.let(Edition::named), home, sharesCompiler = settings.sharesCompiler, comparesSolutions = true)
    } catch (e: IOException) {
        throw InputError("cannot write to $home (${e.reason()}): is the disk full or the folder read-only?", e)
    }
}
