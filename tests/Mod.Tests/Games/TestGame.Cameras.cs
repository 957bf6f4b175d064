using GTA.Native;
using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives about cameras.</summary>
internal sealed partial class TestGame
{
    private const float OwnVerticalFovDegrees = 65;

    /// <summary>The camera of the picture: a scripted one, or the game's own behind the player.</summary>
    public (Pose Pose, float VerticalFovDegrees) RenderedCamera =>
        Cameras.TryGetValue(RenderingCamera, out GameCamera? camera)
            ? (Entities[camera.AttachedTo].Pose.Compose(new Pose(camera.Offset, Axes.Identity)), camera.VerticalFovDegrees)
            : (Entities[Player].Pose.Compose(new Pose(new Vector3D(0, -4, 1), Axes.Identity)), OwnVerticalFovDegrees);

    private void AddCameraNatives()
    {
        _natives[Hash.CREATE_CAM_WITH_PARAMS] = a =>
        {
            Cameras[++_lastHandle] = new GameCamera { VerticalFovDegrees = (float)a[7] };
            return _lastHandle;
        };
        _natives[Hash.DOES_CAM_EXIST] = a => Cameras.ContainsKey((int)a[0]);
        _natives[Hash.HARD_ATTACH_CAM_TO_ENTITY] = a =>
        {
            GameCamera camera = Cameras[(int)a[0]];
            camera.AttachedTo = (int)a[1];
            camera.Offset = ToWorld(a[5], a[6], a[7]);
            return null;
        };
        _natives[Hash.SET_CAM_ACTIVE] = a =>
        {
            Cameras[(int)a[0]].IsActive = (bool)a[1];
            return null;
        };
        _natives[Hash.DESTROY_CAM] = a =>
        {
            Cameras.Remove((int)a[0]);
            return null;
        };
        _natives[Hash.GET_RENDERING_CAM] = _ => RenderingCamera;
        _natives[Hash.RENDER_SCRIPT_CAMS] = a =>
        {
            RenderingCamera = (bool)a[0] ? Cameras.First(camera => camera.Value.IsActive).Key : -1;
            return null;
        };
        _natives[Hash.GET_FINAL_RENDERED_CAM_COORD] = _ => ToGame(RenderedCamera.Pose.Position);
        _natives[Hash.GET_FINAL_RENDERED_CAM_ROT] = _ =>
        {
            EulerAngles angles = RenderedCamera.Pose.Axes.ToEuler();
            return ToGame(new Vector3D(angles.PitchDegrees, angles.RollDegrees, angles.YawDegrees));
        };
        _natives[Hash.GET_FINAL_RENDERED_CAM_FOV] = _ => RenderedCamera.VerticalFovDegrees;
    }
}
