using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// An object in KITTI's terms: in the camera's frame with x right, y down and z forward, an upright box with its size, the centre of its
/// bottom face and its rotation about y; in the image, pixels with integer centres.
/// </summary>
internal sealed class KittiBox
{
    /// <summary>KITTI counts from the centre of the upper left pixel, conventions.md from its corner.</summary>
    public const double PixelShift = -0.5;

    /// <summary>Coordinates have two decimals; a smaller box could round to zero size.</summary>
    private const double MinPixels = 0.02;

    private readonly UprightBox _upright;

    private KittiBox(ObjectLabel label, string type, Box2D box, UprightBox upright)
    {
        Label = label;
        Type = type;
        Box = box;
        _upright = upright;
    }

    /// <summary>The object's label.</summary>
    public ObjectLabel Label { get; }

    /// <summary>The object's type in KITTI.</summary>
    public string Type { get; }

    /// <summary>The 2D box.</summary>
    public Box2D Box { get; }

    /// <summary>
    /// Largest distance between the sides of the projected upright box and those of the projected cuboid, pixels; 0 if the cuboid reaches
    /// behind the camera.
    /// </summary>
    public double MissPixels => _upright.MissPixels;

    /// <summary>Distance between the centres of the upright box and the cuboid, metres.</summary>
    public double MovedMetres => _upright.MovedMetres;

    /// <summary>Angle between the up axes of the cuboid and of the camera, degrees.</summary>
    public double LeanDegrees => _upright.LeanDegrees;

    /// <summary>The objects of a frame that KITTI labels.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="names">Types of classes that do not have the default.</param>
    public static IEnumerable<KittiBox> Of(ExportFrame frame, IReadOnlyDictionary<ObjectClass, string> names)
    {
        CameraLabel camera = frame.Label.Camera;
        foreach (ExportObject item in frame.Objects)
        {
            if (KittiClasses.Has(item.Label.Class) && BoxIn(item.Box, camera) is { } box)
            {
                yield return new KittiBox(item.Label, KittiClasses.TypeOf(item.Label, names), box, UprightBox.Of(item.Label.Box3D, camera));
            }
        }
    }

    /// <summary>The ignore regions of a frame.</summary>
    public static IEnumerable<Box2D> IgnoredIn(ExportFrame frame)
    {
        foreach (ExportRegion region in frame.Ignored)
        {
            if (KittiClasses.Ignores(region.Kind) && BoxIn(region.Box, frame.Label.Camera) is { } box)
            {
                yield return box;
            }
        }
    }

    /// <summary>The fields from alpha to rotation_y, which both label formats of KITTI have.</summary>
    /// <param name="camera">The labelled camera in the frame of camera 0, in which the fields are given.</param>
    public string Fields(Vector3D camera)
    {
        UprightBox box = _upright.InFrameOf(camera);
        return string.Join(
            ' ',
            Numbers.Row(KittiDecimals.Angle, box.Alpha),
            Sides(Box),
            Numbers.Row(KittiDecimals.Metres, box.Height, box.Width, box.Length, box.Location.X, box.Location.Y, box.Location.Z),
            Numbers.Row(KittiDecimals.Angle, box.RotationY)
        );
    }

    /// <summary>The four fields of a 2D box.</summary>
    public static string Sides(Box2D box) => Numbers.Row(KittiDecimals.Pixels, box.XMin, box.YMin, box.XMax, box.YMax);

    /// <summary>A 2D box in KITTI's pixels; null if it contains no pixel centre and so would have no area.</summary>
    private static Box2D? BoxIn(Box2D box, CameraLabel camera)
    {
        var shifted = new Box2D(
            Place(box.XMin, camera.Width),
            Place(box.YMin, camera.Height),
            Place(box.XMax, camera.Width),
            Place(box.YMax, camera.Height)
        );
        return shifted.Width >= MinPixels && shifted.Height >= MinPixels ? shifted : null;
    }

    private static double Place(double side, int size) => Math.Clamp(side + PixelShift, 0, size - 1);
}
