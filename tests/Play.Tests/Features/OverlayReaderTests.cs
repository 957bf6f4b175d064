using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Features;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Tests.Features;

public sealed class OverlayReaderTests
{
    private const int Ticks = 60;
    private readonly ScriptedReader _game = new();
    private readonly OverlayReader _sight;

    public OverlayReaderTests()
    {
        _sight = new OverlayReader(_game);
    }

    [Fact]
    public void Vehicle_in_view_is_found_where_it_is_in_every_tick()
    {
        _game.Add(EntityKind.Vehicle, 1, new Vector3D(0, 20, 0));
        for (int tick = 0; tick < Ticks; tick++)
        {
            _game.Places[1] += new Vector3D(0, 0.5, 0);
            Assert.Equal(_game.Places[1], Assert.Single(Look()).Place.Pose.Position);
        }

        Assert.Equal((1, Ticks), (_game.FactsAsked, _game.PlacesAsked));
    }

    [Fact]
    public void Vehicle_behind_the_camera_is_polled_rarely_but_in_time()
    {
        const double metresPerTick = 1.2;
        _game.Add(EntityKind.Vehicle, 1, new Vector3D(3, -60, 0));
        int asked = 0;
        for (int tick = 0; tick < 200 && _game.Places[1].Y < 20; tick++)
        {
            _game.Places[1] += new Vector3D(0, metresPerTick, 0);
            IReadOnlyList<SeenEntity> seen = Look();
            asked = _game.Places[1].Y < -20 ? _game.PlacesAsked : asked;
            if (_game.Places[1].Y + ScriptedReader.HalfLength > 0)
            {
                Assert.Equal(_game.Places[1], Assert.Single(seen).Place.Pose.Position);
            }
        }

        Assert.InRange(asked, 3, 8);
    }

    [Fact]
    public void Ped_entering_or_leaving_a_vehicle_is_noticed_soon()
    {
        _game.Add(EntityKind.Ped, 1, new Vector3D(0, 20, 0));
        Assert.Single(Look());
        _game.OnFoot.Remove(1);
        Assert.InRange(TicksUntil(seen => seen.Count == 0), 1, 15);
        _game.OnFoot.Add(1);
        Assert.InRange(TicksUntil(seen => seen.Count == 1), 1, 15);
    }

    [Fact]
    public void Animal_is_not_seen()
    {
        _game.Add(EntityKind.Ped, 1, new Vector3D(0, 20, 0));
        _game.Animals.Add(1);
        Assert.Equal(Ticks, TicksWhile(seen => seen.Count == 0));
    }

    [Fact]
    public void Static_entities_are_polled_rarely_and_spread_over_ticks()
    {
        const int props = 30;
        for (int prop = 0; prop < props; prop++)
        {
            _game.Add(EntityKind.Prop, prop, new Vector3D(prop, 20, 0));
        }

        Look();
        int most = 0;
        for (int tick = 0; tick < Ticks; tick++)
        {
            int before = _game.PlacesAsked;
            Assert.Equal(props, Look().Count);
            most = Math.Max(most, _game.PlacesAsked - before);
        }

        Assert.Equal(props + (props * Ticks / 30), _game.PlacesAsked);
        Assert.Equal(1, most);
    }

    [Fact]
    public void Deleted_entity_disappears_at_once_and_its_handle_is_reusable()
    {
        _game.Add(EntityKind.Vehicle, 1, new Vector3D(0, 20, 0));
        Look();
        _game.Remove(1);
        Assert.Equal(Ticks, TicksWhile(seen => seen.Count == 0));

        _game.Add(EntityKind.Vehicle, 1, new Vector3D(0, 30, 0), "bus");
        Assert.InRange(TicksUntil(seen => seen.Count == 1), 1, 6);
        Assert.Equal(("bus", 30), (Assert.Single(Look()).Model.Name, Assert.Single(Look()).Place.Pose.Position.Y));
    }

    [Fact]
    public void Entity_with_an_unreadable_position_is_omitted_until_readable()
    {
        _game.Add(EntityKind.Prop, 1, new Vector3D(0, 20, 0));
        _game.Unreadable.Add(1);
        Assert.Empty(Look());
        _game.Unreadable.Clear();
        Assert.Single(Look());
    }

    [Fact]
    public void Lists_are_queried_once_in_several_ticks()
    {
        Assert.Equal(Ticks, TicksWhile(seen => seen.Count == 0));
        Assert.Equal(3 * Ticks / 6, _game.ListsAsked);
    }

    [Fact]
    public void Window_is_polled_occasionally_and_the_lens_in_every_tick()
    {
        for (int tick = 0; tick < Ticks; tick++)
        {
            _game.VerticalFovDegrees = 40 + tick;
            Assert.Equal(new CameraState(_game.CameraPose, 40 + tick, 0.1, 1.5), _sight.ReadCamera());
        }

        Assert.Equal(2, _game.WindowsAsked);
    }

    [Fact]
    public void Ego_is_available_while_the_camera_is_mounted()
    {
        Assert.Null(_sight.ReadEgo());
        _game.Add(EntityKind.Vehicle, 7, new Vector3D(1, 2, 3));
        _game.MountedVehicle = 7;
        for (int tick = 0; tick < Ticks; tick++)
        {
            Assert.Equal(new Vector3D(1, 2, 3), _sight.ReadEgo()!.Value.Place.Pose.Position);
        }

        Assert.Equal((1, Ticks), (_game.FactsAsked, _game.PlacesAsked));
    }

    private IReadOnlyList<SeenEntity> Look() => _sight.Around(_sight.ReadCamera().Pose, 100);

    private int TicksWhile(Predicate<IReadOnlyList<SeenEntity>> isSo) => Enumerable.Range(0, Ticks).TakeWhile(_ => isSo(Look())).Count();

    private int TicksUntil(Predicate<IReadOnlyList<SeenEntity>> isSo)
    {
        int ticks = 1;
        while (!isSo(Look()))
        {
            Assert.True(ticks < Ticks, "It never comes.");
            ticks++;
        }

        return ticks;
    }

    /// <summary>Entities around a camera that looks north from the origin, and counts of how often each value was read.</summary>
    private sealed class ScriptedReader : ISightReader
    {
        public const double HalfLength = 2;
        private readonly Dictionary<int, (EntityKind Kind, string Model)> _entities = [];

        public Dictionary<int, Vector3D> Places { get; } = [];

        public HashSet<int> OnFoot { get; } = [];

        public HashSet<int> Animals { get; } = [];

        public HashSet<int> Unreadable { get; } = [];

        public int FactsAsked { get; private set; }

        public int PlacesAsked { get; private set; }

        public int ListsAsked { get; private set; }

        public int WindowsAsked { get; private set; }

        public int MountedVehicle { get; set; }

        public Pose CameraPose => new(Vector3D.Zero, Axes.Identity);

        public double VerticalFovDegrees { get; set; } = 50;

        public double NearClip => 0.1;

        public double WindowAspect
        {
            get
            {
                WindowsAsked++;
                return 1.5;
            }
        }

        public void Add(EntityKind kind, int entity, Vector3D place, string model = "asea")
        {
            _entities[entity] = (kind, model);
            Unreadable.Remove(entity);
            Places[entity] = place;
            OnFoot.Add(entity);
        }

        public void Remove(int entity)
        {
            _entities.Remove(entity);
            Unreadable.Add(entity);
        }

        public IReadOnlyList<int> Near(EntityKind kind, Vector3D centre, double range)
        {
            ListsAsked++;
            return [.. _entities.Where(entity => entity.Value.Kind == kind).Select(entity => entity.Key)];
        }

        public ModelFacts FactsOf(EntityKind kind, int entity)
        {
            FactsAsked++;
            return new ModelFacts(
                ObjectClass.Car,
                _entities[entity].Model,
                new Vector3D(-1, -HalfLength, 0),
                new Vector3D(1, HalfLength, 1)
            );
        }

        public ScaledPose? PlaceOf(int entity)
        {
            PlacesAsked++;
            return Unreadable.Contains(entity) ? null : new ScaledPose(new Pose(Places[entity], Axes.Identity), new Vector3D(1, 1, 1));
        }

        public bool IsPerson(int ped) => !Animals.Contains(ped);

        public bool IsInVehicle(int ped) => !OnFoot.Contains(ped);
    }
}
