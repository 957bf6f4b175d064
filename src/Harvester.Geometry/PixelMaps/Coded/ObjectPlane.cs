using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>
/// What the pictures show of one object: the pixels in its silhouette that change with it, also behind others, with its colour there and
/// the colour of what is behind it.
/// </summary>
internal sealed class ObjectPlane
{
    /// <summary>An object may reach beyond its cuboid: by this many pixels, and by this fraction of the silhouette.</summary>
    private const double MarginPixels = 2;
    private const double MarginFraction = 0.02;

    private readonly SilhouetteSpans _spans;

    public ObjectPlane(MapTarget target, ImageSize image)
    {
        Target = target;
        _spans = Widened(target, image);
        Width = Math.Max(0, _spans.LastColumn - _spans.FirstColumn + 1);
        Height = Math.Max(0, _spans.LastRow - _spans.FirstRow + 1);
        int count = Width * Height;
        State = new PixelState[count];
        Colours = new float[3 * count];
        Behind = new float[3 * count];
        Counts = new byte[2 * count];
    }

    public MapTarget Target { get; }

    /// <summary>First column and row of the plane in the image.</summary>
    public int Left => _spans.FirstColumn;

    public int Top => _spans.FirstRow;

    public int Width { get; }

    public int Height { get; }

    public PixelState[] State { get; }

    /// <summary>Mean colour of the object, three channels a pixel.</summary>
    public float[] Colours { get; }

    /// <summary>Mean colour of what is behind it.</summary>
    public float[] Behind { get; }

    /// <summary>Number of pictures of both means.</summary>
    public byte[] Counts { get; }

    /// <summary>First and last column of the silhouette in a row of the image.</summary>
    public (int First, int Last) Row(int row) => _spans.Row(row);

    /// <summary>Whether the silhouette covers a pixel of the image.</summary>
    public bool Covers(int column, int row) => _spans.Contains(column, row);

    /// <summary>The index of a pixel of the image; -1 outside the plane.</summary>
    public int IndexOf(int column, int row) =>
        column >= Left && column < Left + Width && row >= Top && row < Top + Height ? ((row - Top) * Width) + column - Left : -1;

    /// <summary>Whether a pixel of the plane is the object's; pixels outside are not.</summary>
    public bool Has(int x, int y) => StateAt(x, y) == PixelState.Object;

    public PixelState StateAt(int x, int y) => x < 0 || y < 0 || x >= Width || y >= Height ? PixelState.Other : State[(y * Width) + x];

    public Vector3D ColourAt(int index) => new(Colours[3 * index], Colours[(3 * index) + 1], Colours[(3 * index) + 2]);

    public Vector3D BehindAt(int index) => new(Behind[3 * index], Behind[(3 * index) + 1], Behind[(3 * index) + 2]);

    public void Set(int index, Vector3D colour, int count, Vector3D behind, int countBehind)
    {
        State[index] = PixelState.Object;
        (Colours[3 * index], Colours[(3 * index) + 1], Colours[(3 * index) + 2]) = ((float)colour.X, (float)colour.Y, (float)colour.Z);
        (Behind[3 * index], Behind[(3 * index) + 1], Behind[(3 * index) + 2]) = ((float)behind.X, (float)behind.Y, (float)behind.Z);
        (Counts[2 * index], Counts[(2 * index) + 1]) = ((byte)count, (byte)countBehind);
    }

    private static SilhouetteSpans Widened(MapTarget target, ImageSize image)
    {
        IReadOnlyList<Vector2D> outline = target.Projection.Silhouette;
        if (target.Projection.Box is not { } box || outline.Count == 0)
        {
            return new SilhouetteSpans([], new Box2D(0, 0, 0, 0), image);
        }

        var middle = new Vector2D(outline.Average(point => point.X), outline.Average(point => point.Y));
        Vector2D[] wide =
        [
            .. outline.Select(point =>
            {
                // Each corner moves away from the middle by MarginPixels, and by MarginFraction of its distance from it.
                Vector2D arm = point - middle;
                double length = Math.Sqrt((arm.X * arm.X) + (arm.Y * arm.Y));
                return length > 0 ? middle + (arm * (1 + MarginFraction + (MarginPixels / length))) : point;
            }),
        ];
        double more = MarginPixels + (MarginFraction * Math.Max(box.Width, box.Height));
        return new SilhouetteSpans(wide, new Box2D(box.XMin - more, box.YMin - more, box.XMax + more, box.YMax + more), image);
    }
}
