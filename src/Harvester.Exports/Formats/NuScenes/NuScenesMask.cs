using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>
/// Draws a map mask as the devkit reads it: ten pixels per metre, 255 for ground that is in a polygon. Column i and row j stand for the
/// point i/10 m east and (height - j)/10 m north of the lower left corner.
/// </summary>
internal sealed class NuScenesMask
{
    /// <summary>Pixels per metre, as fixed by the devkit.</summary>
    private const int PixelsPerMetre = 10;

    /// <summary>Longest side, pixels: 4 km, more than that of any map of nuScenes. A larger mask is left out.</summary>
    private const int MaxSide = 40_000;

    private readonly ImageSize _size;
    private readonly ILookup<int, Vector2D[]> _byFirstRow;
    private readonly List<Vector2D[]> _active = [];
    private readonly List<double> _crossings = [];

    /// <summary>Prepares a mask.</summary>
    /// <param name="area">What it shows.</param>
    /// <param name="ground">Polygons, metres, world.</param>
    public NuScenesMask(NuScenesArea area, IEnumerable<Vector2D[]> ground)
    {
        bool fits = Math.Max(area.Width, area.Height) <= MaxSide / PixelsPerMetre;
        _size = fits ? new ImageSize(area.Width * PixelsPerMetre, area.Height * PixelsPerMetre) : new ImageSize(1, 1);
        _byFirstRow = (fits ? ground : [])
            .Select(polygon => Array.ConvertAll(polygon, InPixels))
            .ToLookup(polygon => Math.Max(0, (int)Math.Ceiling(polygon.Min(corner => corner.Y))));

        Vector2D InPixels(Vector2D corner) => new((corner.X - area.West) * PixelsPerMetre, (area.North - corner.Y) * PixelsPerMetre);
    }

    /// <summary>Writes the mask as PNG, row by row.</summary>
    public void Write(Stream stream) => new PngEncoder().WriteGrey8(_size, FillRow, stream);

    private void FillRow(int row, byte[] line)
    {
        Array.Clear(line);
        _active.AddRange(_byFirstRow[row]);
        _active.RemoveAll(polygon => polygon.Max(corner => corner.Y) < row);
        foreach (Vector2D[] polygon in _active)
        {
            FindCrossings(polygon, row);
            for (int i = 0; i + 1 < _crossings.Count; i += 2)
            {
                int first = Math.Max(0, (int)Math.Ceiling(_crossings[i]));
                int last = Math.Min(line.Length - 1, (int)Math.Floor(_crossings[i + 1]));
                if (last >= first)
                {
                    line.AsSpan(first, last - first + 1).Fill(byte.MaxValue);
                }
            }
        }
    }

    private void FindCrossings(Vector2D[] polygon, int row)
    {
        _crossings.Clear();
        Vector2D from = polygon[^1];
        foreach (Vector2D to in polygon)
        {
            if (from.Y <= row != to.Y <= row)
            {
                _crossings.Add(from.X + ((row - from.Y) * (to.X - from.X) / (to.Y - from.Y)));
            }

            from = to;
        }

        _crossings.Sort();
    }
}
