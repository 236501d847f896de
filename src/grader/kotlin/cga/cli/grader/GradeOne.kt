package cga.cli.grader

import cga.framework.Home
import cga.grading.course.GradeOne
import cga.grading.course.NoSandboxError
import cga.grading.pipeline.Pipeline
import cga.grading.prepared.Edition
import cga.grading.sandbox.Sandbox

/** What grades one submission, in a sandbox unless [settings] allow none. Throws [NoSandboxError] where there is no sandbox. */
internal fun gradeOne(settings: PipelineSettings): GradeOne {
    val missing = Sandbox.unavailable.takeUnless { settings.unsafeNoSandbox }
    if (missing != null) throw NoSandboxError(missing)
    val sandbox = if (settings.unsafeNoSandbox) Sandbox.unconfined() else Sandbox.confined()
    val home = Home.resolve("build/cga/grading").toAbsolutePath()
    return Pipeline(sandbox, settings.edition?.let(Edition::named), home, sharesCompiler = settings.sharesCompiler)
}
