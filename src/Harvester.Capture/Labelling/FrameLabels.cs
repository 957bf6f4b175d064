using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Puts the label line of a frame together.</summary>
internal static class FrameLabels
{
    public static FrameLabel Of(int frame, FrameDraft draft, Camera camera, ImageFormat format)
    {
        SceneSnapshot scene = draft.Snapshot;
        return new FrameLabel(
            frame,
            scene.GameFrame,
            scene.TimeSeconds,
            draft.LagFrames,
            draft.LagSeconds,
            FramePaths.Image(frame, format),
            draft.Labelling.Mask is null ? null : FramePaths.Mask(frame),
            Of(camera),
            Of(scene.Ego),
            scene.Environment,
            draft.Labelling.Objects)
        {
            PixelMap = draft.Labelling.PixelMap,
            Rays = draft.Labelling.Rays,
            IgnoreRegions = draft.Labelling.IgnoreRegions,
            Lanes = draft.Labelling.Lanes,
        };
    }

    /// <summary>The vehicle that carries the camera as labels have it.</summary>
    public static EgoLabel Of(EgoState ego) => new(ego.Pose.Position, Angles.HeadingDegrees(ego.Pose.Axes.Forward), ego.Velocity, ego.Model)
    {
        Axes = ego.Pose.Axes,
        HeightAboveGroundMetres = ego.HeightAboveGroundMetres,
    };

    /// <summary>The camera as labels have it.</summary>
    public static CameraLabel Of(Camera camera)
    {
        CameraIntrinsics intrinsics = camera.Intrinsics;
        return new CameraLabel(
            camera.Pose,
            intrinsics.VerticalFovDegrees,
            intrinsics.Image.Width,
            intrinsics.Image.Height,
            intrinsics.WindowAspect,
            intrinsics.NearClip,
            intrinsics.Fx,
            intrinsics.Fy,
            intrinsics.Cx,
            intrinsics.Cy,
            new DistortionLabel(intrinsics.Lens.FocalScale, intrinsics.Lens.K1, intrinsics.Lens.K2));
    }
}
