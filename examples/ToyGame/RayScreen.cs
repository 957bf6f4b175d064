using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace ToyGame;

/// <summary>The picture of the game, one ray for each pixel: a blue sky, a grey ground, and a colour for each entity.</summary>
internal sealed class RayScreen(IWorld world, IRayCaster rays) : IScreen
{
    private const double Reach = 200;

    public GrabResult Grab(PixelBuffer target)
    {
        CameraState state = world.ReadCamera();
        var lens = new CameraIntrinsics(state.VerticalFovDegrees, target.Size, state.WindowAspect, state.NearClip, Lens.Ideal);
        var camera = new Camera(state.Pose, lens);
        for (int row = 0; row < target.Size.Height; row++)
        {
            for (int column = 0; column < target.Size.Width; column++)
            {
                // The centre of a pixel is half a pixel from its corner.
                RayHit? hit = rays.Cast(camera.RayThrough(column + 0.5, row + 0.5), Reach, RayHit.World);
                Paint(target, column, row, hit);
            }
        }

        return GrabResult.Good;
    }

    // A pixel is red, green, blue.
    private static void Paint(PixelBuffer target, int column, int row, RayHit? hit)
    {
        (byte red, byte green, byte blue) = hit switch
        {
            null => ((byte)120, (byte)180, (byte)230),
            { Entity: RayHit.World } => ((byte)90, (byte)90, (byte)90),
            { Entity: int handle } => ((byte)200, (byte)40, (byte)(60 * handle)),
        };
        int at = ((row * target.Size.Width) + column) * PixelBuffer.BytesPerPixel;
        (target.Bytes[at], target.Bytes[at + 1], target.Bytes[at + 2]) = (red, green, blue);
    }
}
