using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>Where the sheets on the ground are seen, and where they would be if no object were in front of them.</summary>
internal sealed class SheetMap
{
    /// <summary>A sheet is trusted if it is seen in this fraction of the places where no object is, and in so many.</summary>
    private const double TrustedFraction = 0.5;
    private const int TrustedPixels = 8;

    /// <summary>Near its border a sheet may lie below a kerb, metres: it is expected to be seen only farther inside.</summary>
    private const double BorderMetres = 0.25;

    private readonly Camera _camera;
    private readonly ushort[][] _objects;
    private readonly HashSet<ObjectPlane> _own;
    private readonly byte[] _first;
    private readonly byte[] _last;
    private readonly Dictionary<ObjectPlane, List<GroundSheet>> _sheets = [];

    public SheetMap(Camera camera, IReadOnlyList<ObjectPlane> planes, ushort[][] objects, byte[] first, byte[] last)
    {
        _camera = camera;
        _objects = objects;
        _first = first;
        _last = last;
        List<(GroundSheet Sheet, ObjectPlane Plane)> trusted = [];
        foreach (ObjectPlane plane in planes)
        {
            GroundSheet sheet = GroundSheet.Under(plane.Target);
            if (IsTrusted(sheet, plane, objects))
            {
                trusted.Add((sheet, plane));
            }
        }

        _own = [.. trusted.Select(each => each.Plane)];
        foreach (ObjectPlane plane in planes)
        {
            _sheets[plane] = [.. trusted.Where(each => each.Plane.IsNear(plane)).Select(each => each.Sheet)];
        }
    }

    /// <summary>Whether a pixel shows a sheet more than anything else.</summary>
    public bool IsSeen(int pixel)
    {
        double share = 0;
        double squared = 0;
        for (int channel = 0; channel < 3; channel++)
        {
            double before = _first[(3 * pixel) + channel];
            double span = (channel == 1 ? GroundSheet.Colour.Y : GroundSheet.Colour.X) - before;
            share += span * (_last[(3 * pixel) + channel] - before);
            squared += span * span;
        }

        return 2 * share > squared;
    }

    /// <summary>Whether a pixel of a plane would show a sheet without the objects.</summary>
    public bool IsExpected(ObjectPlane plane, int column, int row)
    {
        List<GroundSheet> sheets = _sheets[plane];
        if (sheets.Count == 0)
        {
            return false;
        }

        Ray ray = _camera.RayThrough(column + 0.5, row + 0.5);
        return sheets.Any(sheet => sheet.IsMet(ray, BorderMetres));
    }

    /// <summary>Whether a pixel in which nothing changes would show the sheet under an object, and does not: something is there.</summary>
    public bool IsMissing(ObjectPlane plane, int pixel)
    {
        (int column, int row) = (pixel % _camera.Image.Width, pixel / _camera.Image.Width);
        return _objects[pixel] is null && _own.Contains(plane) && !IsSeen(pixel)
            && GroundSheet.Under(plane.Target).IsMet(_camera.RayThrough(column + 0.5, row + 0.5), BorderMetres);
    }

    private bool IsTrusted(GroundSheet sheet, ObjectPlane plane, ushort[][] objects)
    {
        (int expected, int seen, int seenInside) = (0, 0, 0);
        for (int row = plane.Top; row < plane.Top + plane.Height; row++)
        {
            for (int column = plane.Left; column < plane.Left + plane.Width; column++)
            {
                int pixel = (row * _camera.Image.Width) + column;
                Ray ray = _camera.RayThrough(column + 0.5, row + 0.5);
                if (sheet.IsMet(ray))
                {
                    bool isSeen = IsSeen(pixel);
                    seen += isSeen ? 1 : 0;
                    if (sheet.IsMet(ray, BorderMetres))
                    {
                        seenInside += isSeen ? 1 : 0;
                        expected += isSeen || objects[pixel] is null ? 1 : 0;
                    }
                }
            }
        }

        return seen >= TrustedPixels && seenInside >= TrustedFraction * expected;
    }
}
