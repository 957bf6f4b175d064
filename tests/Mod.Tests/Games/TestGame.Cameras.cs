using GTA.Native;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives about cameras.</summary>
internal sealed partial class TestGame
{
    public const float Aspect = 4f / 3;
    public const int NoCamera = -1;
    private const float NearClip = 0.15f;
    private const float OwnVerticalFovDegrees = 65;

    public Dictionary<int, GameCamera> Cameras { get; } = [];

    public int RenderingCamera { get; set; } = NoCamera;

    /// <summary>The camera of the picture when a scripted one renders; null for the one that the mod has mounted.</summary>
    public Func<CameraState>? SceneCamera { get; set; }

    /// <summary>The camera of the picture: a scripted one, or the game's own behind the player.</summary>
    public CameraState RenderedCamera
    {
        get
        {
            if (!Cameras.TryGetValue(RenderingCamera, out GameCamera? camera))
            {
                return Seen(Entities[Player].Pose.Compose(new Pose(new Vector3D(0, -4, 1), Axes.Identity)), OwnVerticalFovDegrees);
            }

            if (camera.AttachedTo == 0)
            {
                return Seen(camera.Pose, camera.VerticalFovDegrees);
            }

            return SceneCamera?.Invoke()
                ?? Seen(Entities[camera.AttachedTo].Pose.Compose(new Pose(camera.Offset, camera.Turn)), camera.VerticalFovDegrees);
        }
    }

    private static CameraState Seen(Pose pose, double verticalFovDegrees) => new(pose, verticalFovDegrees, NearClip, Aspect);

    private void AddCameraNatives()
    {
        _natives[Hash.CREATE_CAM_WITH_PARAMS] = a =>
        {
            Cameras[++_lastHandle] = new GameCamera
            {
                Pose = new Pose(ToWorld(a[1], a[2], a[3]), Axes.FromEuler(new EulerAngles((float)a[4], (float)a[5], (float)a[6]))),
                VerticalFovDegrees = (float)a[7],
            };
            return _lastHandle;
        };
        _natives[Hash.DOES_CAM_EXIST] = a => Cameras.ContainsKey((int)a[0]);
        Do(
            Hash.HARD_ATTACH_CAM_TO_ENTITY,
            a =>
            {
                GameCamera camera = Cameras[(int)a[0]];
                camera.AttachedTo = (int)a[1];
                if (!IsCameraHeld)
                {
                    camera.Offset = ToWorld(a[5], a[6], a[7]);
                    camera.Turn = Axes.FromEuler(new EulerAngles((float)a[2], (float)a[3], (float)a[4]));
                }
            }
        );
        Do(Hash.SET_CAM_FOV, a => Cameras[(int)a[0]].VerticalFovDegrees = (float)a[1]);
        Do(Hash.SET_CAM_ACTIVE, a => Cameras[(int)a[0]].IsActive = (bool)a[1]);
        Do(Hash.DESTROY_CAM, a => Cameras.Remove((int)a[0]));
        _natives[Hash.GET_RENDERING_CAM] = _ => RenderingCamera;
        Do(Hash.RENDER_SCRIPT_CAMS, a => RenderingCamera = (bool)a[0] ? Cameras.First(camera => camera.Value.IsActive).Key : NoCamera);
        _natives[Hash.GET_FINAL_RENDERED_CAM_COORD] = _ => ToGame(RenderedCamera.Pose.Position);
        _natives[Hash.GET_FINAL_RENDERED_CAM_ROT] = _ =>
        {
            EulerAngles angles = RenderedCamera.Pose.Axes.ToEuler();
            return ToGame(new Vector3D(angles.PitchDegrees, angles.RollDegrees, angles.YawDegrees));
        };
        _natives[Hash.GET_FINAL_RENDERED_CAM_FOV] = _ => (float)RenderedCamera.VerticalFovDegrees;
        _natives[Hash.GET_FINAL_RENDERED_CAM_NEAR_CLIP] = _ => (float)RenderedCamera.NearClip;
        _natives[Hash.GET_ASPECT_RATIO] = _ => (float)RenderedCamera.WindowAspect;
    }
}
