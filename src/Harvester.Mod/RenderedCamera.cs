using GTA.Math;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod;

/// <summary>The camera that the game rendered last, whether of this mod, of the game or of another mod.</summary>
internal static class RenderedCamera
{
    public static Pose Pose
    {
        get
        {
            Vector3D degrees = Natives.ToWorld(Natives.Call<Vector3>(Hash.GET_FINAL_RENDERED_CAM_ROT, Natives.RotationOrder));
            return new Pose(
                Natives.ToWorld(Natives.Call<Vector3>(Hash.GET_FINAL_RENDERED_CAM_COORD)),
                Axes.FromEuler(new EulerAngles(degrees.X, degrees.Y, degrees.Z))
            );
        }
    }

    public static double VerticalFovDegrees => Natives.Call<float>(Hash.GET_FINAL_RENDERED_CAM_FOV);

    public static double NearClip => Natives.Call<float>(Hash.GET_FINAL_RENDERED_CAM_NEAR_CLIP);

    public static double WindowAspect => Natives.Call<float>(Hash.GET_ASPECT_RATIO, false);

    /// <summary>Reads all its properties.</summary>
    public static CameraState Read() => new(Pose, VerticalFovDegrees, NearClip, WindowAspect);
}
