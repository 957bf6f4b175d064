using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading;

/// <summary>Creates cameras from labels read from a file, whose values may be out of range.</summary>
public static class LabelCamera
{
    /// <summary>The camera that a label describes.</summary>
    /// <exception cref="DatasetFormatException">A value is out of range; the message names it.</exception>
    public static Camera Of(CameraLabel label)
    {
        try
        {
            return label.ToCamera();
        }
        catch (ArgumentException e)
        {
            throw new DatasetFormatException($"camera: {e.Message}", e);
        }
    }
}
