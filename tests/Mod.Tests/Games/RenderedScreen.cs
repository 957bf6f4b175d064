using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Mod.Tests.Games;

/// <summary>
/// A screen that shows the objects of a test game that have shapes, drawn by the simulation's renderer with the camera of the moment.
/// </summary>
internal sealed class RenderedScreen : IScreen
{
    private readonly Renderer _renderer = new();

    /// <summary>The game; it is made after its screen.</summary>
    public TestGame? Game { get; set; }

    public GrabResult Grab(PixelBuffer target)
    {
        CameraState camera = Game!.RenderedCamera;
        var scene = new RenderScene([
            .. Game
                .Entities.Where(entity => entity.Value.Shape is not null)
                .Select(entity => new MeshInstance(entity.Value.Shape!, entity.Value.Pose, entity.Key)),
        ]);
        var picture = new RenderTarget(target.Size.Width, target.Size.Height);
        _renderer.Render(
            scene,
            new RenderCamera(
                camera.Pose,
                camera.VerticalFovDegrees,
                camera.WindowAspect,
                camera.NearClip,
                target.Size.Width,
                target.Size.Height
            ),
            picture
        );

        // What is met is white, all else black: the test wants to know where the thing is, not how it is lit.
        for (int pixel = 0; pixel < picture.Handles.Length; pixel++)
        {
            target
                .Bytes.AsSpan(pixel * PixelBuffer.BytesPerPixel, PixelBuffer.BytesPerPixel)
                .Fill(picture.Handles[pixel] > 0 ? (byte)255 : (byte)0);
        }

        return GrabResult.Good;
    }
}
