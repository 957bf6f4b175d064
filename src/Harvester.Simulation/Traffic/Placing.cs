using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Places vehicles on lanes: all at the beginning, later those that have reached a dead end or are stuck.</summary>
internal sealed class Placing
{
    private const double EndRoom = 8;
    private const double Room = 2.5;
    private const int Attempts = 60;
    private const int AttemptsOnEndless = 30;
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

    /// <summary>Where the ego starts: on a lane from which it can drive on forever, as close to a point as possible.</summary>
    /// <param name="near">The point.</param>
    /// <param name="visit">
    /// Number of the visited place: the ego starts beside the point, and in turn in each lane of its direction. Null to start at the
    /// beginning of the nearest lane.
    /// </param>
    /// <exception cref="ArgumentException">No lane is long enough.</exception>
    public (LanePath Path, double Distance) StartOfEgo(Vector3D near, int? visit = null)
    {
        const double shortest = 30;
        LanePath? path =
            _paths
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
        if (visit is not { } number)
        {
            return (path, least);
        }

        LanePath[] abreast =
        [
            .. _paths
                .Where(other =>
                    other.Road == path.Road && other.IsForward == path.IsForward && other.GoesOn == path.GoesOn && other.Length > shortest
                )
                .OrderBy(other => other.Lane),
        ];
        path = abreast.Length > 0 ? abreast[number % abreast.Length] : path;
        return (path, Math.Clamp(LanePlace.Of(path, near, path.Length / 2).Distance, least, path.Length - least));
    }

    /// <summary>A random start of the ego on lanes from which it can drive on forever, each metre of them equally likely.</summary>
    /// <param name="seed">Random seed.</param>
    /// <exception cref="ArgumentException">No lane is long enough.</exception>
    public (LanePath Path, double Distance) RandomStartOfEgo(int seed)
    {
        LanePath[] paths = [.. _paths.Where(path => path.GoesOn && path.Road is { IsUnpaved: false })];
        double left = new Random(seed).NextDouble() * paths.Sum(Usable);
        foreach (LanePath path in paths)
        {
            if (left < Usable(path))
            {
                return (path, EndRoom + left);
            }

            left -= Usable(path);
        }

        return StartOfEgo(Vector3D.Zero);

        static double Usable(LanePath path) => path.Length - (2 * EndRoom);
    }

    /// <summary>Places the ego, which other vehicles are later not placed near.</summary>
    public void PutEgo(Vehicle ego, (LanePath Path, double Distance) start)
    {
        _ego = ego;
        ego.PutOn(start.Path, start.Distance);
    }

    /// <summary>Places a vehicle at a random free position about which a condition holds; if none is found, it is not placed.</summary>
    /// <returns>Whether it was placed.</returns>
    public bool PutWhere(Vehicle vehicle, Func<Vector3D, Vector3D, bool> isWanted, Func<Footprint, bool> isFree)
    {
        const double step = 5;
        List<(LanePath Path, double Distance)> places = [];
        foreach (LanePath path in _paths)
        {
            for (double distance = EndRoom; distance < path.Length - EndRoom; distance += step)
            {
                if (isWanted(path.Line.PositionAt(distance), path.Line.TangentAt(distance)))
                {
                    places.Add((path, distance));
                }
            }
        }

        for (int i = 0; i < Attempts && places.Count > 0; i++)
        {
            (LanePath path, double distance) = places[_random.Next(places.Count)];
            vehicle.PutOn(path, distance);
            if (isFree(vehicle.Footprint.Grown(Room)))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>
    /// Places a vehicle at a random free position; if none is found, it is not moved. The ego is placed where it can drive on forever, or
    /// on any road if no such place is found, as where all roads end.
    /// </summary>
    /// <returns>Whether it was moved.</returns>
    public bool Replace(Vehicle vehicle, Func<Footprint, bool> isFree)
    {
        (LanePath Path, double Distance) before = vehicle.Route.Count > 0 ? (vehicle.Path, vehicle.Distance) : default;
        for (int i = 0; i < Attempts; i++)
        {
            int index = Array.BinarySearch(_summedLengths, _random.NextDouble() * LaneMetres);
            LanePath path = _paths[Math.Min(index >= 0 ? index : ~index, _paths.Count - 1)];
            double distance = EndRoom + (_random.NextDouble() * (path.Length - (2 * EndRoom)));
            bool mayBeSeen =
                before.Path is not null
                && _ego is not null
                && vehicle != _ego
                && (path.Line.PositionAt(distance) - _ego.Pose.Position).Length < OutOfSight;
            if (mayBeSeen || (vehicle == _ego && !path.GoesOn && i < AttemptsOnEndless))
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
