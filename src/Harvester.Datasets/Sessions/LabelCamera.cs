using System;
using Harvester.Datasets.Files;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Sessions;

/// <summary>Makes the camera of a label again, to project with.</summary>
public static class LabelCamera
{
    /// <summary>The camera that a label describes.</summary>
    /// <exception cref="DatasetFormatException">A value is outside its range; the message names it.</exception>
    public static Camera Of(CameraLabel label)
    {
        try
        {
            return Make(label);
        }
        catch (ArgumentException e)
        {
            throw new DatasetFormatException($"camera: {e.Message}", e);
        }
    }

    private static Camera Make(CameraLabel label)
    {
        DistortionLabel distortion = label.Distortion;
        var lens = new Lens(
            distortion.FocalScale, (label.Cx / label.Width) - 0.5, (label.Cy / label.Height) - 0.5, distortion.K1, distortion.K2);
        return new Camera(label.Pose, new CameraIntrinsics(
            label.VerticalFovDegrees, new ImageSize(label.Width, label.Height), label.WindowAspect, label.NearClip, lens));
    }
}
