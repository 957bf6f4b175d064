using GTA.Native;
using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>The game's scripted cameras, by its natives.</summary>
internal sealed class GameCameras(GameBuild build) : ICameras
{
    /// <inheritdoc/>
    public string? AttachingProblem => build.MountProblem;

    /// <inheritdoc/>
    public int Make(Pose pose, double verticalFovDegrees)
    {
        Vector3D place = pose.Position;
        EulerAngles angles = pose.Axes.ToEuler();
        int camera = Natives.Call<int>(
            Hash.CREATE_CAM_WITH_PARAMS,
            "DEFAULT_SCRIPTED_CAMERA",
            (float)place.X,
            (float)place.Y,
            (float)place.Z,
            (float)angles.PitchDegrees,
            (float)angles.RollDegrees,
            (float)angles.YawDegrees,
            (float)verticalFovDegrees,
            true,
            Natives.RotationOrder
        );

        // Whether it exists is not checked: if the check failed, the camera would be unknown and never removed. -1 means that there is
        // none.
        return Math.Max(camera, 0);
    }

    /// <inheritdoc/>
    public void Attach(int camera, int vehicle, Pose mount)
    {
        EulerAngles angles = mount.Axes.ToEuler();
        Vector3D offset = mount.Position;
        Natives.Call(
            Hash.HARD_ATTACH_CAM_TO_ENTITY,
            camera,
            vehicle,
            (float)angles.PitchDegrees,
            (float)angles.RollDegrees,
            (float)angles.YawDegrees,
            (float)offset.X,
            (float)offset.Y,
            (float)offset.Z,
            true
        );
    }

    /// <inheritdoc/>
    public void Zoom(int camera, double verticalFovDegrees) => Natives.Call(Hash.SET_CAM_FOV, camera, (float)verticalFovDegrees);

    /// <inheritdoc/>
    public void Show(int camera)
    {
        Natives.Call(Hash.SET_CAM_ACTIVE, camera, true);
        RenderScripted(true);
    }

    /// <inheritdoc/>
    public void Remove(int camera)
    {
        if (!Exists(camera))
        {
            return;
        }

        if (Natives.Call<int>(Hash.GET_RENDERING_CAM) == camera)
        {
            RenderScripted(false);
        }

        Natives.Call(Hash.SET_CAM_ACTIVE, camera, false);
        Natives.Call(Hash.DESTROY_CAM, camera, false);
    }

    private static bool Exists(int camera) => Natives.Call<bool>(Hash.DOES_CAM_EXIST, camera);

    private static void RenderScripted(bool render)
    {
        const int easeMilliseconds = 0;
        const int unknown = 0;
        Natives.Call(Hash.RENDER_SCRIPT_CAMS, render, false, easeMilliseconds, true, false, unknown);
    }
}
