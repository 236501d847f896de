package cga.coach.calls

import org.lwjgl.system.libffi.FFIType
import org.lwjgl.system.libffi.LibFFI.ffi_type_double
import org.lwjgl.system.libffi.LibFFI.ffi_type_float
import org.lwjgl.system.libffi.LibFFI.ffi_type_pointer
import org.lwjgl.system.libffi.LibFFI.ffi_type_sint32
import org.lwjgl.system.libffi.LibFFI.ffi_type_sint64
import org.lwjgl.system.libffi.LibFFI.ffi_type_uint8
import org.lwjgl.system.libffi.LibFFI.ffi_type_void

/**
 * The functions of OpenGL 3.3 that a game may draw with, each with its C signature: first what it returns, then its arguments.
 *
 * `v` void, `i` 32-bit integer or enum, `z` GLboolean, `f` float, `d` double, `l` GLsizeiptr or GLintptr, `p` pointer.
 */
internal object Signatures {
    private const val TABLE = """
        glActiveTexture=vi glAttachShader=vii glBindAttribLocation=viip glBindBuffer=vii glBindBufferBase=viii glBindBufferRange=viiill
        glBindFragDataLocation=viip glBindFramebuffer=vii glBindRenderbuffer=vii glBindSampler=vii glBindTexture=vii glBindVertexArray=vi
        glBlendColor=vffff glBlendEquation=vi glBlendEquationSeparate=vii glBlendFunc=vii glBlendFuncSeparate=viiii
        glBlitFramebuffer=viiiiiiiiii glBufferData=vilpi glBufferSubData=villp glClear=vi glClearBufferfi=viifi glClearBufferfv=viip
        glClearBufferiv=viip glClearBufferuiv=viip glClearColor=vffff glClearDepth=vd glClearStencil=vi glColorMask=vzzzz
        glCompileShader=vi glCopyBufferSubData=viilll glCopyTexImage2D=viiiiiiii glCopyTexSubImage2D=viiiiiiii glCreateProgram=i
        glCreateShader=ii glCullFace=vi glDeleteBuffers=vip glDeleteFramebuffers=vip glDeleteProgram=vi glDeleteShader=vi
        glDeleteQueries=vip glDeleteRenderbuffers=vip glDeleteSamplers=vip
        glDeleteTextures=vip glDeleteVertexArrays=vip glDepthFunc=vi glDepthMask=vz glDepthRange=vdd glDetachShader=vii glDisable=vi
        glDisableVertexAttribArray=vi glDrawArrays=viii glDrawArraysInstanced=viiii glDrawBuffer=vi glDrawBuffers=vip glDrawElements=viiip
        glDrawElementsBaseVertex=viiipi glDrawElementsInstanced=viiipi glDrawElementsInstancedBaseVertex=viiipii
        glDrawRangeElements=viiiiip glDrawRangeElementsBaseVertex=viiiiipi glEnable=vi glEnableVertexAttribArray=vi
        glFramebufferRenderbuffer=viiii glFramebufferTexture2D=viiiii glFrontFace=vi glGenBuffers=vip glGenFramebuffers=vip
        glGenQueries=vip glGenRenderbuffers=vip glGenSamplers=vip
        glGenTextures=vip glGenVertexArrays=vip glGenerateMipmap=vi glGetAttribLocation=iip glGetError=i glGetIntegerv=vip
        glGetProgramiv=viip glGetShaderiv=viip glGetUniformLocation=iip glHint=vii glIsEnabled=zi glLineWidth=vf glLinkProgram=vi
        glMapBuffer=pii glMapBufferRange=pilli glMultiDrawArrays=vippi glMultiDrawElements=vipipi glMultiDrawElementsBaseVertex=vipipip
        glPixelStorei=vii glPointSize=vf glPolygonMode=vii glPolygonOffset=vff glReadBuffer=vi glReadPixels=viiiiiip glScissor=viiii
        glSamplerParameterf=viif glSamplerParameterfv=viip glSamplerParameteri=viii glSamplerParameteriv=viip
        glShaderSource=viipp glStencilFunc=viii glStencilMask=vi glStencilOp=viii glTexImage1D=viiiiiiip glTexImage2D=viiiiiiiip
        glTexImage2DMultisample=viiiiiz glTexImage3D=viiiiiiiiip glTexParameterf=viif glTexParameterfv=viip glTexParameteri=viii
        glTexParameteriv=viip glTexStorage2D=viiiii glTexSubImage2D=viiiiiiiip glUniform1f=vif glUniform1fv=viip glUniform1i=vii
        glUniform1iv=viip glUniform1ui=vii glUniform1uiv=viip glUniform2f=viff glUniform2fv=viip glUniform2i=viii glUniform2iv=viip
        glUniform2ui=viii glUniform2uiv=viip glUniform3f=vifff glUniform3fv=viip glUniform3i=viiii glUniform3iv=viip glUniform3ui=viiii
        glUniform3uiv=viip glUniform4f=viffff glUniform4fv=viip glUniform4i=viiiii glUniform4iv=viip glUniform4ui=viiiii glUniform4uiv=viip
        glUniformBlockBinding=viii glUniformMatrix2fv=viizp glUniformMatrix2x3fv=viizp glUniformMatrix2x4fv=viizp glUniformMatrix3fv=viizp
        glUniformMatrix3x2fv=viizp glUniformMatrix3x4fv=viizp glUniformMatrix4fv=viizp glUniformMatrix4x2fv=viizp
        glUniformMatrix4x3fv=viizp glUnmapBuffer=zi glUseProgram=vi glValidateProgram=vi glVertexAttrib1f=vif glVertexAttrib2f=viff
        glVertexAttrib3f=vifff glVertexAttrib4f=viffff glVertexAttribDivisor=vii glVertexAttribIPointer=viiiip glVertexAttribPointer=viiizip
        glViewport=viiii
    """

    /** Signatures by name. */
    val byName: Map<String, String> = TABLE.trim().split(Regex("\\s+")).associate { it.substringBefore('=') to it.substringAfter('=') }

    /** How libffi calls the type [letter]. */
    fun type(letter: Char): FFIType =
        when (letter) {
            'v' -> ffi_type_void
            'i' -> ffi_type_sint32
            'z' -> ffi_type_uint8
            'f' -> ffi_type_float
            'd' -> ffi_type_double
            'l' -> ffi_type_sint64
            'p' -> ffi_type_pointer
            else -> error("no type has the letter $letter")
        }
}
