using System;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>Tells from what was asked around a place whether an object could be seen there at all.</summary>
internal sealed class HiddenPlaces(Camera camera, PixelSamples samples)
{
    /// <summary>What was asked so many rows and columns away at most, half a first cell, tells how far away a place is.</summary>
    private const int Reach = 16;

    /// <summary>Whether all that was asked nearby of what the pixel shows lies before the object's cuboid.</summary>
    public bool IsHidden(MapTarget target, InstanceMap map, int column, int row)
    {
        if (target.Cuboid.Intersect(camera.RayThrough(column + 0.5, row + 0.5)) is not { } span)
        {
            return true;
        }

        bool anyNearer = false;
        for (int r = Math.Max(0, row - Reach); r <= Math.Min(camera.Image.Height - 1, row + Reach); r++)
        {
            for (int c = Math.Max(0, column - Reach); c <= Math.Min(camera.Image.Width - 1, column + Reach); c++)
            {
                if (samples.HasDistance(c, r) && samples.Number(c, r) == map[column, row])
                {
                    if (samples.Distance(c, r) > span.Entry)
                    {
                        return false;
                    }

                    anyNearer = true;
                }
            }
        }

        return anyNearer;
    }
}
