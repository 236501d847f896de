package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
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

class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram

    var meshGround: Mesh
    var ground: Renderable = Renderable()
    var cycle: Renderable
    var tronCamera: TronCamera = TronCamera()

    var pointLight: PointLight
    var pointLight2: PointLight
    var pointLight3: PointLight
    var pointLight4: PointLight
    var spotLight: SpotLight

    var oldMousePosX: Double = -1.0
    var oldMousePosY: Double = -1.0
    var firstMove: Boolean = true

    //scene setup
    init {
        staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow("clear")
        glEnable(GL_CULL_FACE); GLError.checkThrow("cull")
        glFrontFace(GL_CCW); GLError.checkThrow("front")
        glCullFace(GL_BACK); GLError.checkThrow("back")
        glEnable(GL_DEPTH_TEST); GLError.checkThrow("depth")
        glDepthFunc(GL_LESS); GLError.checkThrow("func")

        //Ground
        val groundDiff = Texture2D("assets/textures/ground_diff.png", true)
        groundDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundEmit = Texture2D("assets/textures/ground_emit.png", true)
        groundEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundSpec = Texture2D("assets/textures/ground_spec.png", true)
        groundSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(groundDiff, groundEmit, groundSpec, 60.0f, Vector2f(64.0f, 64.0f))

        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val posAttrib = VertexAttribute(3, 8 * 4, 0)
        val texAttrib = VertexAttribute(2, 8 * 4, 3 * 4)
        val normAttrib = VertexAttribute(3, 8 * 4, 5 * 4)
        meshGround = Mesh(res.vertexData, res.indexData, arrayOf(posAttrib, texAttrib, normAttrib), groundMaterial)
        ground.meshes.add(meshGround)

        //Bike
        cycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        cycle.scaleLocal(Vector3f(0.8f))

        //Camera
        tronCamera.parent = cycle
        tronCamera.rotateLocal(Math.toRadians(-35.0f), 0.0f, 0.0f)
        tronCamera.translateLocal(Vector3f(0.0f, 0.0f, 4.0f))

        //Lights
        pointLight = PointLight(Vector3f(0.0f, 2.0f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f), Vector3f(1.0f, 0.5f, 0.1f))
        pointLight.parent = cycle
        pointLight2 = PointLight(Vector3f(10.0f, 2.0f, -10.0f), Vector3f(10.0f, 0.0f, 0.0f), Vector3f(1.0f, 0.5f, 0.1f))
        pointLight3 = PointLight(Vector3f(-10.0f, 2.0f, -10.0f), Vector3f(0.0f, 0.0f, 10.0f), Vector3f(1.0f, 0.5f, 0.1f))
        pointLight4 = PointLight(Vector3f(10.0f, 2.0f, 10.0f), Vector3f(8.0f, 8.0f, 0.0f), Vector3f(1.0f, 0.5f, 0.1f))

        spotLight = SpotLight(Vector3f(0.0f, 1.0f, -2.0f), Vector3f(3.0f, 3.0f, 3.0f), Vector3f(0.5f, 0.05f, 0.01f), Vector2f(Math.toRadians(15.0f), Math.toRadians(30.0f)))
        spotLight.rotateLocal(Math.toRadians(-10.0f), 0.0f, 0.0f)
        spotLight.parent = cycle
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()
        tronCamera.bind(staticShader)

        val r = Math.abs(Math.sin(t))
        val g = Math.abs(Math.sin(t / 2.0f))
        val b = Math.abs(Math.sin(t / 3.0f))
        pointLight.lightCol = Vector3f(r, g, b)

        pointLight.bind(staticShader, "pointLight")
        pointLight2.bind(staticShader, "pointLight2")
        pointLight3.bind(staticShader, "pointLight3")
        pointLight4.bind(staticShader, "pointLight4")
        spotLight.bind(staticShader, "spotLight", tronCamera.getCalculateViewMatrix())

        staticShader.setUniform("objectColor", Vector3f(0.0f, 1.0f, 0.0f))
        ground.render(staticShader)
        staticShader.setUniform("objectColor", Vector3f(r, g, b))
        cycle.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W) == true) {
            cycle.translateLocal(Vector3f(0.0f, 0.0f, -5.0f * dt))
            if (window.getKeyState(GLFW_KEY_A) == true) {
                cycle.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            }
            if (window.getKeyState(GLFW_KEY_D) == true) {
                cycle.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            }
        }
        if (window.getKeyState(GLFW_KEY_S) == true) {
            cycle.translateLocal(Vector3f(0.0f, 0.0f, 5.0f * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMove == true) {
            oldMousePosX = xpos
            oldMousePosY = ypos
            firstMove = false
        }
        val deltaX = oldMousePosX - xpos
        val deltaY = oldMousePosY - ypos
        oldMousePosX = xpos
        oldMousePosY = ypos
        tronCamera.rotateAroundPoint(0.0f, (deltaX * 0.002f).toFloat(), 0.0f, Vector3f(0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        cycle.cleanup()
        staticShader.cleanup()
    }
}
