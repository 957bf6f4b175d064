using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Places vehicles on lanes: all at the beginning, later those that have reached a dead end or are stuck.</summary>
internal sealed class Placing
{
    private const double EndRoom = 8;
    private const double Room = 2.5;
    private const int Attempts = 60;
    private const double OutOfSight = 120;

    private readonly Random _random;
    private readonly List<LanePath> _paths;
    private readonly double[] _summedLengths;
    private Vehicle? _ego;

    public Placing(LaneGraph lanes, int seed)
    {
        _random = new Random(seed);
        _paths = [.. lanes.Paths.Where(path => path.Road is { IsInner: false } && path.Length > 2 * EndRoom)];
        _summedLengths = new double[_paths.Count];
        double sum = 0;
        for (int i = 0; i < _paths.Count; i++)
        {
            _summedLengths[i] = sum += _paths[i].Length;
        }
    }

    /// <summary>Total length of the lanes on which vehicles can be placed, metres.</summary>
    public double LaneMetres => _summedLengths.Length == 0 ? 0 : _summedLengths[^1];

    /// <summary>Places the ego on a lane from which it can drive on for ever, as close to a point as possible.</summary>
    /// <param name="ego">The ego.</param>
    /// <param name="near">The point.</param>
    /// <param name="isBeside">Whether it starts beside the point; otherwise at the beginning of the lane.</param>
    /// <exception cref="ArgumentException">No lane is long enough.</exception>
    public void PutEgo(Vehicle ego, Vector3D near, bool isBeside = false)
    {
        _ego = ego;
        const double shortest = 30;
        LanePath? path = _paths
            .Where(path => path.Length > shortest)
            .OrderBy(path => path.GoesOn ? 0 : 1)
            .ThenBy(path => path.Road!.IsUnpaved ? 1 : 0)
            .ThenBy(path => Horizontal.SquaredDistance(path.Line.PositionAt(path.Length / 2), near))
            .FirstOrDefault()
            ?? _paths.MaxBy(path => path.Length);
        if (path is null)
        {
            throw new ArgumentException("No lane is long enough to drive on; choose another place.");
        }

        double least = Math.Min(EndRoom, path.Length / 2);
        ego.PutOn(path, isBeside ? Math.Clamp(LanePlace.Of(path, near, path.Length / 2).Distance, least, path.Length - least) : least);
    }

    /// <summary>Places a vehicle at a random free position; if none is found, it is not moved.</summary>
    /// <returns>Whether it was moved.</returns>
    public bool Replace(Vehicle vehicle, Func<Footprint, bool> isFree)
    {
        (LanePath Path, double Distance) before = vehicle.Route.Count > 0 ? (vehicle.Path, vehicle.Distance) : default;
        for (int i = 0; i < Attempts; i++)
        {
            int index = Array.BinarySearch(_summedLengths, _random.NextDouble() * LaneMetres);
            LanePath path = _paths[Math.Min(index >= 0 ? index : ~index, _paths.Count - 1)];
            double distance = EndRoom + (_random.NextDouble() * (path.Length - (2 * EndRoom)));
            bool mayBeSeen = before.Path is not null && _ego is not null && vehicle != _ego
                && (path.Line.PositionAt(distance) - _ego.Pose.Position).Length < OutOfSight;
            if (mayBeSeen || (vehicle == _ego && !path.GoesOn))
            {
                continue;
            }

            vehicle.PutOn(path, distance);
            if (isFree(vehicle.Footprint.Grown(Room)))
            {
                return true;
            }
        }

        if (before.Path is not null)
        {
            vehicle.PutOn(before.Path, before.Distance);
        }

        return false;
    }
}
