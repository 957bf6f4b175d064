using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// The cameras of KITTI's car: 0 and 1 grey, 2 and 3 in colour, all rectified. A rig has them if its cameras have the same size, field of
/// view, lens and direction: two are 2 and 3, the left one first; four are 0 to 3 in the order of the rig. The views of another rig, and
/// the camera of a session without one, are frames of their own, with camera 2 only.
/// </summary>
internal sealed class KittiRig
{
    /// <summary>The camera whose images have labels.</summary>
    public const int Reference = 2;

    /// <summary>The camera in whose frame KITTI gives objects, poses and the place of the laser scanner.</summary>
    public const int Origin = 0;

    /// <summary>The cameras in colour follow the grey ones, of which they stand for those that a rig lacks.</summary>
    private const int GreyCameras = 2;

    /// <summary>Number of cameras.</summary>
    public const int Cameras = 4;

    /// <summary>Difference of directions that counts as none.</summary>
    private const double Tolerance = 1e-9;

    private readonly int[] _views;

    private KittiRig(int[] views) => _views = views;

    /// <summary>Whether the views of a moment belong together.</summary>
    public bool IsRectified => _views.Length > 1;

    /// <summary>The number of a view's camera; 2 if its views do not belong together.</summary>
    public int SlotOf(int view) => IsRectified ? Cameras - _views.Length + Array.IndexOf(_views, view) : Reference;

    /// <summary>The view of a camera; null if there is no such camera.</summary>
    public int? ViewOf(int slot) => slot - (Cameras - _views.Length) is var index && IsRectified && index >= 0 ? _views[index] : null;

    /// <summary>The cameras of a rig.</summary>
    public static KittiRig Of(Rig? rig)
    {
        if (rig is not { Cameras.Count: 2 or Cameras } || !rig.Cameras.All(camera => IsParallel(camera, rig.Cameras[0])))
        {
            return new KittiRig([0]);
        }

        IEnumerable<int> views = Enumerable.Range(0, rig.Cameras.Count);
        return new KittiRig([
            .. rig.Cameras.Count == 2 ? views.OrderBy(view => InAxesOf(rig.Cameras[0].Mount, rig.Cameras[view].Mount).X) : views,
        ]);
    }

    /// <summary>
    /// P0 to P3, row by row, from the frame of camera 0 to the pixels of each: K (I | -c), with the camera at c.
    /// </summary>
    /// <param name="frame">The frame of the reference camera.</param>
    public IEnumerable<double[]> Projections(ExportFrame frame)
    {
        CameraLabel camera = frame.Label.Camera;
        (double cx, double cy) = (camera.Cx + KittiBox.PixelShift, camera.Cy + KittiBox.PixelShift);
        for (int slot = 0; slot < Cameras; slot++)
        {
            (double right, double down, double ahead) = PlaceOf(slot, frame);
            yield return
            [
                camera.Fx,
                0,
                cx,
                -(camera.Fx * right) - (cx * ahead),
                0,
                camera.Fy,
                cy,
                -(camera.Fy * down) - (cy * ahead),
                0,
                0,
                1,
                -ahead,
            ];
        }
    }

    /// <summary>The mount of a camera on the vehicle. A pair has virtual cameras 0 and 1 at the places of 2 and 3.</summary>
    /// <param name="slot">Number of the camera.</param>
    /// <param name="frame">The frame of the reference camera.</param>
    public Pose MountOf(int slot, ExportFrame frame) =>
        frame.Rig!.Cameras[ViewOf(slot) ?? ViewOf(slot + GreyCameras) ?? (frame.Label.Frame % frame.Rig.Cameras.Count)].Mount;

    /// <summary>Where a camera is in the frame of camera 0: x right, y down, z forward, metres.</summary>
    /// <param name="slot">Number of the camera.</param>
    /// <param name="frame">The frame of the reference camera.</param>
    public Vector3D PlaceOf(int slot, ExportFrame frame)
    {
        Vector3D place = IsRectified ? InAxesOf(MountOf(Origin, frame), MountOf(slot, frame)) : Vector3D.Zero;
        return new Vector3D(place.X, -place.Z, place.Y);
    }

    /// <summary>The pose of a camera in the world.</summary>
    /// <param name="slot">Number of the camera.</param>
    /// <param name="frame">The frame of the reference camera.</param>
    public Pose PoseOf(int slot, ExportFrame frame)
    {
        Pose reference = frame.Label.Camera.Pose;
        return IsRectified
            ? reference with
            {
                Position = reference.ToWorld(InAxesOf(MountOf(Reference, frame), MountOf(slot, frame))),
            }
            : reference;
    }

    private static Vector3D InAxesOf(Pose camera, Pose other) => camera.ToLocal(other.Position);

    private static bool IsParallel(RigCamera camera, RigCamera other) =>
        camera.Image == other.Image
        && camera.VerticalFovDegrees == other.VerticalFovDegrees
        && camera.Lens == other.Lens
        && (camera.Mount.Axes.Forward - other.Mount.Axes.Forward).Length < Tolerance
        && (camera.Mount.Axes.Up - other.Mount.Axes.Up).Length < Tolerance;
}
