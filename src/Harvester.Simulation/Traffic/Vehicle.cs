using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>A vehicle that drives along lanes, and the ways it has chosen to drive next.</summary>
internal sealed class Vehicle
{
    private const double PlannedAhead = 80;

    private readonly Random _random;
    private readonly List<LanePath> _route = [];

    /// <summary>Of a vehicle that does not keep to a lane's line: where it is along each way that it is in the way on.</summary>
    private Dictionary<LanePath, double>? _places;
    private Vector3D _freeVelocity;

    public Vehicle(int handle, Model model, int seed, double cruiseSpeed)
    {
        Handle = handle;
        Model = model;
        CruiseSpeed = cruiseSpeed;
        _random = new Random(seed);
    }

    public int Handle { get; }

    public Model Model { get; }

    /// <summary>Speed on a free straight street, metres per second.</summary>
    public double CruiseSpeed { get; }

    /// <summary>The way it is on and those that follow.</summary>
    public IReadOnlyList<LanePath> Route => _route;

    public LanePath Path => _route[0];

    /// <summary>Metres from the start of its way to its origin.</summary>
    public double Distance { get; private set; }

    public double Speed { get; set; }

    /// <summary>Seconds it has not moved.</summary>
    public double StandingSeconds { get; set; }

    public Pose Pose { get; private set; }

    public Footprint Footprint { get; private set; }

    public Vector3D Velocity => _places is null ? Pose.Axes.Forward * Speed : _freeVelocity;

    /// <summary>The ways that it is on.</summary>
    public IEnumerable<LanePath> Ways => _places is null ? [Path] : _places.Keys;

    /// <summary>Ways through junctions that it has been given, in the order of driving.</summary>
    public List<LanePath> Granted { get; } = [];

    public double FrontOverhang => Model.Max.Y;

    public double RearOverhang => -Model.Min.Y;

    public bool CanGoOn => _route.Count > 1 || Path.Next.Count > 0;

    public void PutOn(LanePath path, double distance)
    {
        _route.Clear();
        _route.Add(path);
        _places = null;
        Speed = 0;
        StandingSeconds = 0;
        Plan();
        MoveTo(distance);
    }

    /// <summary>Moves it off its lane's line.</summary>
    /// <param name="place">Where it is along the way that it follows; another than it had planned makes it plan anew.</param>
    /// <param name="pose">Its pose.</param>
    /// <param name="speed">Metres per second.</param>
    /// <param name="velocity">The same with its direction.</param>
    /// <param name="alsoOn">The ways that it is on besides.</param>
    public void MoveFreely(LanePlace place, Pose pose, double speed, Vector3D velocity, IEnumerable<LanePlace> alsoOn)
    {
        int planned = _route.IndexOf(place.Path);
        _route.RemoveRange(0, planned >= 0 ? planned : _route.Count);
        if (planned < 0)
        {
            _route.Add(place.Path);
        }

        Plan();
        Distance = place.Distance;
        Speed = speed;
        Pose = pose;
        Footprint = Footprint.Of(Pose, Model.Min, Model.Max);
        _freeVelocity = velocity;
        _places = alsoOn.ToDictionary(other => other.Path, other => other.Distance);
        _places[place.Path] = place.Distance;
    }

    /// <summary>Metres from the start of a way that it is on.</summary>
    public double DistanceOn(LanePath way) => _places is not null && _places.TryGetValue(way, out double distance) ? distance : Distance;

    /// <summary>Its speed along a way that it is on; 0 across and against it.</summary>
    public double SpeedOn(LanePath way) =>
        _places is null ? Speed : Math.Max(0, _freeVelocity.Dot(way.Line.TangentAt(DistanceOn(way))));

    /// <summary>The pose some metres further along its route.</summary>
    public Pose PoseAhead(double metres)
    {
        (LanePath path, double distance) = PlaceAhead(metres);
        Axes axes = Horizontal.AxesAlong(path.Line.TangentAt(distance));
        return new Pose(path.Line.PositionAt(distance) - (axes.Up * Model.Min.Z), axes);
    }

    public Footprint FootprintAhead(double metres) => Footprint.Of(PoseAhead(metres), Model.Min, Model.Max);

    /// <summary>Drives some metres along the route.</summary>
    public void Advance(double metres)
    {
        double distance = Distance + metres;
        while (distance > Path.Length && _route.Count > 1)
        {
            distance -= Path.Length;
            _route.RemoveAt(0);
        }

        Plan();
        MoveTo(Math.Min(distance, Path.Length));
    }

    /// <summary>The way and the place on it that lie some metres ahead; the end of the route at most.</summary>
    public (LanePath Path, double Distance) PlaceAhead(double metres)
    {
        double distance = Distance + metres;
        int i = 0;
        while (distance > _route[i].Length && i < _route.Count - 1)
        {
            distance -= _route[i].Length;
            i++;
        }

        return (_route[i], Math.Min(distance, _route[i].Length));
    }

    private void MoveTo(double distance)
    {
        Distance = distance;
        Pose = PoseAhead(0);
        Footprint = Footprint.Of(Pose, Model.Min, Model.Max);
    }

    private void Plan()
    {
        double length = _route.Sum(path => path.Length);
        while (length < PlannedAhead + Path.Length && _route[^1].Next.Count > 0)
        {
            List<LanePath> next = [.. _route[^1].Next.Where(path => path.GoesOn)];
            next = next.Count > 0 ? next : _route[^1].Next;
            _route.Add(next[_random.Next(next.Count)]);
            length += _route[^1].Length;
        }
    }
}
