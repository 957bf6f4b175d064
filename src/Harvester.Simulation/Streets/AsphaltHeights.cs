using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>
/// The height of the asphalt where roads overlap: it runs smoothly from one to the other. Where only one road has its carriageway, the
/// height is that of the road's line.
/// </summary>
internal sealed class AsphaltHeights(StreetIndex index, RoadLevels levels)
{
    /// <summary>Maximum height difference of roads on one level, metres; farther ones are on another bridge.</summary>
    private const double SameLevel = 2.5;

    /// <summary>Depth of a shoulder under another road's carriageway, and of dirt under asphalt, metres: enough to be hidden.</summary>
    private const double Sunk = 0.03;

    /// <summary>Distance beside the asphalt at which paths through a junction still keep its height, metres.</summary>
    private const double Beside = 6;

    /// <summary>The smallest distance and depth in a weight, metres; it avoids a division by zero.</summary>
    private const double Least = 1e-6;

    /// <summary>The height at a point, metres; null where no road's asphalt is.</summary>
    /// <param name="place">The point; its height chooses the level.</param>
    public double? At(Vector3D place)
    {
        RoadPlace[] places = OnLevel(place);
        return OnCarriageways(place, places) ?? Weighted(place, places, road => road.Shoulder);
    }

    /// <summary>The height of a vertex of a road's own surface, metres, and whether another road's surface hides it.</summary>
    public (double Height, bool IsHidden) Of(Road road, double distance, double rightOffset, Vector3D place)
    {
        RoadPlace own = new(road, distance, rightOffset, 0);
        RoadPlace[] places = [.. OnLevel(place, except: road), own];
        if (places.Length == 1)
        {
            return (place.Z, false);
        }

        if (OnCarriageways(place, places) is not { } height)
        {
            return (Weighted(place, places, each => each.Shoulder) ?? place.Z, false);
        }

        bool isHidden =
            (!own.IsOnCarriageway(0) && !road.IsInTrim(distance))
            || (road.IsUnpaved && places.Any(other => !other.Road.IsUnpaved && other.IsOnCarriageway(0)));
        return (isHidden ? height - Sunk : height, isHidden);
    }

    /// <summary>The height at which a vehicle drives, metres: also a little beside the asphalt; null far from it.</summary>
    public double? Driven(Vector3D place) => At(place) ?? Weighted(place, OnLevel(place, Beside, Beside), _ => Beside);

    /// <summary>Whether other roads may share a stretch of a road, metres along it, so that its height is not that of its line.</summary>
    public bool IsShared(Road road, double from, double to) => levels.IsShared(road, from, to);

    private RoadPlace[] OnLevel(Vector3D place, double pastTheEnd = 0.05, double beside = Road.WidestShoulder, Road? except = null) =>
        [.. index.PlacesAt(place, pastTheEnd, except, beside).Where(found => Math.Abs(found.Height) < SameLevel)];

    private static double? OnCarriageways(Vector3D place, RoadPlace[] places)
    {
        double sum = 0;
        double weights = 0;
        foreach (RoadPlace on in places)
        {
            // In a junction, shoulders count too: at the corner of two carriageways the height would change abruptly.
            double depth = on.Depth + (on.Road.IsInTrim(on.Distance) ? on.Road.Shoulder : 0);
            if (depth > 0)
            {
                double weight = Math.Min(depth, on.Road.CrossingDepthAt(on.Distance)) + Least;
                sum += weight * on.Height;
                weights += weight;
            }
        }

        return weights > 0 ? place.Z - (sum / weights) : null;
    }

    private static double? Weighted(Vector3D place, RoadPlace[] places, Func<Road, double> reach)
    {
        double sum = 0;
        double weights = 0;
        foreach (RoadPlace beside in places)
        {
            double distance = -beside.Depth;
            double within = reach(beside.Road);
            if (distance < within)
            {
                double weight = (1 / (Math.Max(distance, 0) + Least)) - (1 / (within + Least)) + Least;
                sum += weight * beside.Height;
                weights += weight;
            }
        }

        return weights > 0 ? place.Z - (sum / weights) : null;
    }
}
