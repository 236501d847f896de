package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.framebuffer.Framebuffer
import cga.exercise.components.framebuffer.ScreenQuad
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.skybox.Skybox
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/**
 * Created by Fabian on 16.09.2017.
 */
class Scene(private val window: GameWindow) {
    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val screenShader = ShaderProgram("assets/shaders/screen_vert.glsl", "assets/shaders/screen_frag.glsl")

    private val ground: Renderable
    private val lightCycle: Renderable
    private val skybox: Skybox

    private val pointLight: PointLight
    private val spotLight: SpotLight
    private val pointLights = mutableListOf<PointLight>()

    private val camera = TronCamera()

    // Post-Processing
    private var framebuffer = Framebuffer(window.framebufferWidth, window.framebufferHeight)
    private val screenQuad = ScreenQuad()
    private var effect = 0

    // Maus
    private var firstMouse = true
    private var lastX = 0.0

    init {
        // initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // Boden
        val objMesh = OBJLoader.loadOBJ("assets/models/ground.obj")
        val stride = 8 * 4
        val attributes = arrayOf(
            VertexAttribute(3, stride, 0),
            VertexAttribute(2, stride, 3 * 4),
            VertexAttribute(3, stride, 5 * 4)
        )
        val groundDiff = Texture2D("assets/textures/ground_diff.png", true)
        val groundEmit = Texture2D("assets/textures/ground_emit.png", true)
        val groundSpec = Texture2D("assets/textures/ground_spec.png", true)
        for (tex in listOf(groundDiff, groundEmit, groundSpec)) {
            tex.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        }
        val groundMaterial = Material(groundDiff, groundEmit, groundSpec, 60.0f, Vector2f(64.0f, 64.0f))
        ground = Renderable(mutableListOf(Mesh(objMesh.vertexData, objMesh.indexData, attributes, groundMaterial)))

        // Motorrad
        lightCycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw IllegalArgumentException("Could not load the model")
        lightCycle.scaleLocal(Vector3f(0.8f))

        // Kamera
        camera.parent = lightCycle
        camera.rotateLocal(Math.toRadians(-35.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 4.0f))

        // Licht am Motorrad
        pointLight = PointLight(Vector3f(0.0f, 1.6f, 0.2f), Vector3f(1.0f, 0.0f, 1.0f))
        pointLight.parent = lightCycle
        pointLights.add(pointLight)

        // Lichter in den Ecken
        pointLights.add(PointLight(Vector3f(18.0f, 1.5f, 18.0f), Vector3f(0.0f, 5.0f, 7.0f)))
        pointLights.add(PointLight(Vector3f(-18.0f, 1.5f, 18.0f), Vector3f(7.0f, 0.0f, 5.0f)))
        pointLights.add(PointLight(Vector3f(18.0f, 1.5f, -18.0f), Vector3f(7.0f, 5.0f, 0.0f)))
        pointLights.add(PointLight(Vector3f(-18.0f, 1.5f, -18.0f), Vector3f(7.0f, 0.5f, 0.5f)))

        // Scheinwerfer
        spotLight = SpotLight(Vector3f(0.0f, 1.0f, -1.9f), Vector3f(3.0f), Math.toRadians(15.0f), Math.toRadians(28.0f))
        spotLight.rotateLocal(Math.toRadians(-9.0f), 0.0f, 0.0f)
        spotLight.parent = lightCycle

        skybox = Skybox()
        GLError.checkThrow()
    }

    fun render(dt: Float, t: Float) {
        // das Fenster koennte groesser oder kleiner geworden sein
        if (framebuffer.width != window.framebufferWidth || framebuffer.height != window.framebufferHeight) {
            framebuffer.cleanup()
            framebuffer = Framebuffer(window.framebufferWidth, window.framebufferHeight)
        }

        // 1. Szene in die Textur
        framebuffer.bind()
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        renderScene(t)
        skybox.render(camera)

        // 2. Textur auf den Bildschirm
        framebuffer.unbind(window.framebufferWidth, window.framebufferHeight)
        glClear(GL_COLOR_BUFFER_BIT)
        screenQuad.render(screenShader, framebuffer, effect)
    }

    private fun renderScene(t: Float) {
        val cycleColor = Vector3f(abs(sin(t)), abs(sin(t / 2.0f + 1.0f)), abs(cos(t / 3.0f)))
        pointLight.lightColor = cycleColor

        staticShader.use()
        camera.bind(staticShader)
        staticShader.setUniform("ambientColor", Vector3f(0.04f))
        for (i in pointLights.indices) {
            pointLights[i].bind(staticShader, "[$i]")
        }
        spotLight.bind(staticShader, "spotLight", camera.getCalculateViewMatrix())

        staticShader.setUniform("sceneColor", Vector3f(0.0f, 1.0f, 0.0f))
        ground.render(staticShader)
        staticShader.setUniform("sceneColor", cycleColor)
        lightCycle.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            lightCycle.translateLocal(Vector3f(0.0f, 0.0f, -6.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) lightCycle.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) lightCycle.rotateLocal(0.0f, -1.5f * dt, 0.0f)
        } else if (window.getKeyState(GLFW_KEY_S)) {
            lightCycle.translateLocal(Vector3f(0.0f, 0.0f, 4.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) lightCycle.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) lightCycle.rotateLocal(0.0f, 1.5f * dt, 0.0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        // P schaltet durch die Effekte
        if (key == GLFW_KEY_P && action == GLFW_PRESS) effect = (effect + 1) % 4
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            lastX = xpos
            firstMouse = false
        }
        val offsetX = lastX - xpos
        lastX = xpos
        camera.rotateAroundPoint(0.0f, offsetX.toFloat() * 0.002f, 0.0f, Vector3f(0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        lightCycle.cleanup()
        skybox.cleanup()
        framebuffer.cleanup()
        screenQuad.cleanup()
        screenShader.cleanup()
        staticShader.cleanup()
    }
}
