using System;
using Harvester.Capture.Labels;
using Harvester.Geometry;

namespace Harvester.Datasets.Exports.Kitti;

/// <summary>
/// An object in KITTI's terms: the camera's frame with x right, y down, z forward; a box that stands upright in it, given by its size,
/// the centre of its lower face and its turn about y; pixels whose centres have whole numbers.
/// </summary>
internal sealed record KittiBox
{
    /// <summary>KITTI counts from the centre of the upper left pixel, conventions.md from its corner.</summary>
    public const double PixelShift = -0.5;

    /// <summary>Pixels have two decimals; a box below this could have none.</summary>
    private const double LeastPixels = 0.02;

    public KittiBox(ObjectLabel label, CameraLabel camera)
    {
        Vector3D centre = camera.Pose.ToLocal(label.Box3D.Centre);
        Vector3D forward = camera.Pose.Axes.ToLocal(label.Box3D.Axes.Forward);
        Height = 2 * label.Box3D.HalfExtents.Z;
        Width = 2 * label.Box3D.HalfExtents.X;
        Length = 2 * label.Box3D.HalfExtents.Y;
        Location = new Vector3D(centre.X, -centre.Z + (Height / 2), centre.Y);

        // 0 - y and not -y: the arctangent of a minus zero would give -π for π.
        RotationY = Math.Atan2(0 - forward.Y, forward.X);
        Alpha = Numbers.Wrap(RotationY - Math.Atan2(Location.X, Location.Z));
        Box = new Box2D(
            Column(label.Box2D.XMin, camera.Width), Column(label.Box2D.YMin, camera.Height),
            Column(label.Box2D.XMax, camera.Width), Column(label.Box2D.YMax, camera.Height));
    }

    public double Height { get; }

    public double Width { get; }

    public double Length { get; }

    public Vector3D Location { get; }

    public double RotationY { get; }

    public double Alpha { get; }

    public Box2D Box { get; }

    /// <summary>Whether it reaches over the centre of a pixel at the image's edge: one that does not has no area in the format.</summary>
    public bool IsInImage => Box.Width >= LeastPixels && Box.Height >= LeastPixels;

    /// <summary>The fields from alpha to rotation_y, as both of KITTI's label files have them.</summary>
    public string Fields() => string.Join(
        ' ',
        Numbers.Row(KittiDecimals.Angle, Alpha),
        Numbers.Row(KittiDecimals.Pixels, Box.XMin, Box.YMin, Box.XMax, Box.YMax),
        Numbers.Row(KittiDecimals.Metres, Height, Width, Length, Location.X, Location.Y, Location.Z),
        Numbers.Row(KittiDecimals.Angle, RotationY));

    private static double Column(double side, int size) => Math.Clamp(side + PixelShift, 0, size - 1);
}
