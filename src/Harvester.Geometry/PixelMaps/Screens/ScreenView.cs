using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// The part of three pictures where an object's screen lies: with the object before its screen, with the screen only, and with neither.
/// Places are counted from the upper left corner of the screen's box.
/// </summary>
internal sealed class ScreenView
{
    /// <summary>Where a line of sight ends at the floor of the screen, or so little above it, metres, the ground is seen.</summary>
    private const double GroundMetres = 0.15;

    private readonly Camera _camera;
    private readonly ObjectScreen _screen;
    private readonly byte[] _none;
    private readonly ScreenPicture? _shown;
    private readonly ScreenPicture? _empty;

    public ScreenView(Camera camera, ObjectScreen screen, byte[] none, ScreenPicture? shown, ScreenPicture? empty)
    {
        (_camera, _screen, _none, _shown, _empty) = (camera, screen, none, shown, empty);
        SilhouetteSpans spans = screen.Spans;
        (Left, Top) = (spans.FirstColumn, spans.FirstRow);
        Width = Math.Max(0, spans.LastColumn - spans.FirstColumn + 1);
        Height = Math.Max(0, spans.LastRow - spans.FirstRow + 1);
        HasShown = Seen(shown);
        HasEmpty = Seen(empty);
    }

    public int Left { get; }

    public int Top { get; }

    public int Width { get; }

    public int Height { get; }

    /// <summary>Where the picture of the object before its screen can be used.</summary>
    public bool[] HasShown { get; }

    /// <summary>Where the picture of the screen only can be used.</summary>
    public bool[] HasEmpty { get; }

    public Vector3D Shown(int index) => ColourOf(_shown!.Bytes, index);

    public Vector3D Empty(int index) => ColourOf(_empty!.Bytes, index);

    public Vector3D None(int index) => ColourOf(_none, index);

    /// <summary>Whether the screen would be seen on the ground.</summary>
    public bool IsGround(int index)
    {
        Cuboid box = _screen.Box;
        Ray ray = _camera.RayThrough(Left + (index % Width) + 0.5, Top + (index / Width) + 0.5);

        // Height of the ray's exit from the box over its floor.
        return box.Intersect(ray) is not { } span
            || (ray.Origin + (ray.Direction * span.Exit) - box.Centre).Dot(box.Axes.Up) + box.HalfExtents.Z < GroundMetres;
    }

    private Vector3D ColourOf(byte[] picture, int index)
    {
        int first = 3 * (((Top + (index / Width)) * _camera.Image.Width) + Left + (index % Width));
        return new Vector3D(picture[first], picture[first + 1], picture[first + 2]);
    }

    private bool[] Seen(ScreenPicture? picture)
    {
        var seen = new bool[Width * Height];
        for (int index = 0; picture is not null && index < seen.Length; index++)
        {
            (int column, int row) = (Left + (index % Width), Top + (index / Width));
            seen[index] = IsWithin(column, row) && !picture.IsHidden(column, row);
        }

        return seen;
    }

    /// <summary>Whether the screen covers a pixel and its neighbours, except below, where the object may reach its border.</summary>
    private bool IsWithin(int column, int row)
    {
        SilhouetteSpans spans = _screen.Spans;
        return spans.Contains(column, row)
            && spans.Contains(Math.Max(0, column - 1), row)
            && spans.Contains(Math.Min(_camera.Image.Width - 1, column + 1), row)
            && spans.Contains(column, Math.Max(0, row - 1));
    }
}
