using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>A vehicle that drives along lanes, and the paths that it has chosen to drive next.</summary>
internal sealed class Vehicle
{
    private const double PlannedAhead = 80;

    private readonly Random _random;
    private readonly List<LanePath> _route = [];

    /// <summary>The distances along each path that it blocks, for a vehicle that does not follow a lane's line.</summary>
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
    public double CruiseSpeed { get; set; }

    /// <summary>Whether that is its speed on every kind of road.</summary>
    public bool IsSpeedGiven { get; set; }

    /// <summary>Its current path and those that follow.</summary>
    public IReadOnlyList<LanePath> Route => _route;

    public LanePath Path => _route[0];

    /// <summary>Whether its route comes back to a path, as where a few short lanes lead only to each other.</summary>
    public bool GoesInCircles => _route.Distinct().Count() < _route.Count;

    /// <summary>Metres from the start of its path to its origin.</summary>
    public double Distance { get; private set; }

    public double Speed { get; set; }

    /// <summary>Time for which it has not moved, seconds.</summary>
    public double StandingSeconds { get; set; }

    public Pose Pose { get; private set; }

    public Footprint Footprint { get; private set; }

    public Vector3D Velocity => _places is null && Staged is null ? Pose.Axes.Forward * Speed : _freeVelocity;

    /// <summary>The paths on which it is.</summary>
    public IEnumerable<LanePath> Ways => _places is null ? [Path] : _places.Keys;

    /// <summary>Paths through junctions that were granted to it, in the order of driving.</summary>
    public List<LanePath> Granted { get; } = [];

    /// <summary>The lane at whose end it has stopped; null if it has not, or has left that lane.</summary>
    public LanePath? StoppedOn { get; set; }

    /// <summary>An order to brake that somebody has given to its driver; null for none.</summary>
    public OrderedBraking? Ordered { get; set; }

    /// <summary>Its motion after an impact; null for a vehicle that is driven.</summary>
    public Wreck? Wreck { get; set; }

    /// <summary>Its brake lights and indicators.</summary>
    public VehicleSignals Signals { get; } = new();

    /// <summary>Handle of its rider; 0 without one.</summary>
    public int RiderHandle { get; set; }

    /// <summary>The model of its rider; null for a vehicle that has none.</summary>
    public Model? Rider => Model.Riders.Count > 0 ? Model.Riders[Handle % Model.Riders.Count] : null;

    /// <summary>How an actor moves that somebody has put into the world; null for a vehicle in traffic.</summary>
    public StagedMotion? Staged { get; init; }

    /// <summary>Whether its driver takes no notice of staged actors.</summary>
    public bool IsBlindToStaged { get; set; }

    /// <summary>Chooses the next of several paths; null for a random choice.</summary>
    public Func<IReadOnlyList<LanePath>, LanePath>? Guide { get; set; }

    /// <summary>The side of its open door, -1 left or 1 right; 0 if all are shut.</summary>
    public int OpenDoor { get; set; }

    /// <summary>The corners of its box, with an open door, metres, in the model's frame.</summary>
    public (Vector3D Min, Vector3D Max) Extents => OpenDoor == 0 ? (Model.Min, Model.Max) : DoorModel.ExtentsOf(Model, OpenDoor);

    /// <summary>Its meshes: the vehicle itself, the light of its lamps, and its rider, who is an entity of its own.</summary>
    public IEnumerable<MeshInstance> Instances(VehicleLights lights)
    {
        yield return new MeshInstance(Model.Variant(Handle), Pose, Handle);
        if (Model.Lamps?.Of(lights) is { } lamps)
        {
            yield return new MeshInstance(lamps, Pose, Handle);
        }

        if (OpenDoor != 0)
        {
            yield return new MeshInstance(DoorModel.MeshOf(Model, OpenDoor), Pose, Handle);
        }

        if (Rider is { } rider)
        {
            yield return new MeshInstance(rider.Mesh, Pose, RiderHandle);
        }
    }

    /// <summary>Chooses again what follows its path.</summary>
    public void PlanAgain()
    {
        _route.RemoveRange(1, _route.Count - 1);
        Plan();
    }

    public double FrontOverhang => Model.Max.Y;

    public double RearOverhang => -Model.Min.Y;

    public double Length => FrontOverhang + RearOverhang;

    public bool CanGoOn => _route.Count > 1 || Path.Next.Count > 0;

    public void PutOn(LanePath path, double distance)
    {
        _route.Clear();
        _route.Add(path);
        _places = null;
        Wreck = null;
        Speed = 0;
        StandingSeconds = 0;
        Plan();
        MoveTo(distance);
    }

    /// <summary>Moves it without following its lane's line.</summary>
    /// <param name="place">Its position along the path that it follows; a path that was not planned makes it plan again.</param>
    /// <param name="pose">Its pose.</param>
    /// <param name="speed">Metres per second.</param>
    /// <param name="velocity">Velocity, m/s, world.</param>
    /// <param name="alsoOn">Its positions on other paths.</param>
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

    /// <summary>Moves a staged vehicle, which follows no lanes.</summary>
    /// <param name="pose">Its pose.</param>
    /// <param name="speed">Metres per second.</param>
    /// <param name="velocity">Velocity, m/s, world.</param>
    /// <param name="on">Its positions on the paths that it blocks; empty off the lanes.</param>
    public void MoveStaged(Pose pose, double speed, Vector3D velocity, IEnumerable<LanePlace> on)
    {
        Speed = speed;
        Pose = pose;
        Footprint = Footprint.Of(pose, Extents.Min, Extents.Max);
        _freeVelocity = velocity;
        _places = on.ToDictionary(place => place.Path, place => place.Distance);
    }

    /// <summary>Metres from the start of a path on which it is.</summary>
    public double DistanceOn(LanePath way) => _places is not null && _places.TryGetValue(way, out double distance) ? distance : Distance;

    /// <summary>Its speed along a path on which it is; 0 across and against it.</summary>
    public double SpeedOn(LanePath way) => _places is null ? Speed : Math.Max(0, _freeVelocity.Dot(way.Line.TangentAt(DistanceOn(way))));

    /// <summary>The pose at a distance ahead along its route, metres.</summary>
    public Pose PoseAhead(double metres)
    {
        (LanePath path, double distance) = PlaceAhead(metres);
        (Vector3D position, Vector3D tangent) = path.Line.At(distance);
        Axes axes = Horizontal.AxesAlong(tangent);
        return new Pose(position - (axes.Up * Model.Min.Z), axes);
    }

    public Footprint FootprintAhead(double metres) => Footprint.Of(PoseAhead(metres), Model.Min, Model.Max);

    /// <summary>Moves it along the route.</summary>
    public void Advance(double metres)
    {
        double distance = Distance + metres;
        int planned = _route.Count;
        while (distance > Path.Length && _route.Count > 1)
        {
            distance -= Path.Length;
            _route.RemoveAt(0);
        }

        if (_route.Count < planned)
        {
            Plan();
        }

        MoveTo(Math.Min(distance, Path.Length));
    }

    /// <summary>The path and the position on it at a distance ahead, metres; at most the end of the route.</summary>
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
            List<LanePath> next = Continuing(_route[^1].Next);
            _route.Add(Guide is { } guide ? guide(_route[^1].Next) : next[_random.Next(next.Count)]);
            length += _route[^1].Length;
        }
    }

    /// <summary>
    /// Those of some paths that go on, and among them those that are not on the route yet: nobody turns in circles in a junction.
    /// </summary>
    private List<LanePath> Continuing(List<LanePath> paths)
    {
        List<LanePath> goingOn = paths.FindAll(path => path.GoesOn);
        List<LanePath> candidates = goingOn.Count > 0 ? goingOn : paths;
        List<LanePath> fresh = candidates.FindAll(path => !_route.Contains(path) && !path.Next.Exists(_route.Contains));
        return fresh.Count > 0 ? fresh : candidates;
    }
}
