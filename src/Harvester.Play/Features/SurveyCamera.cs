using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Features;

/// <summary>Takes photographs with a scripted camera of the game and its screen.</summary>
/// <param name="cameras">The game's cameras.</param>
/// <param name="screen">Grabs the picture.</param>
/// <param name="windowAspect">Width divided by height of the game's window.</param>
public sealed class SurveyCamera(ICameras cameras, IScreen screen, Func<double> windowAspect) : ISurveyCamera
{
    /// <summary>Side of a photograph, pixels: enough to read a sign, and a page with all of them can still be opened.</summary>
    private const int Side = 320;

    private int _camera;

    /// <inheritdoc/>
    public bool LookFrom(Pose eye, double verticalFovDegrees)
    {
        // The old one first: if two are active, the game chooses which one is shown.
        LookAway();
        _camera = cameras.Make(eye, verticalFovDegrees);
        if (_camera == 0)
        {
            return false;
        }

        cameras.Show(_camera);
        return true;
    }

    /// <inheritdoc/>
    public PixelBuffer? Grab()
    {
        int width = Math.Max(Side, (int)Math.Round(Side * windowAspect()));
        var whole = new PixelBuffer(new ImageSize(width, Side));
        return screen.Grab(whole).IsGood ? Middle(whole) : null;
    }

    /// <inheritdoc/>
    public void LookAway()
    {
        if (_camera != 0)
        {
            cameras.Remove(_camera);
            _camera = 0;
        }
    }

    private static PixelBuffer Middle(PixelBuffer whole)
    {
        var middle = new PixelBuffer(new ImageSize(Side, Side));
        int left = (whole.Size.Width - Side) / 2;
        for (int row = 0; row < Side; row++)
        {
            Buffer.BlockCopy(
                whole.Bytes,
                ((row * whole.Size.Width) + left) * PixelBuffer.BytesPerPixel,
                middle.Bytes,
                row * Side * PixelBuffer.BytesPerPixel,
                Side * PixelBuffer.BytesPerPixel
            );
        }

        return middle;
    }
}
