using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Tests.Scenes;

/// <summary>
/// A seeded street: houses, lamp posts and trees that belong to the world, and entities (cars, vans, buses, motorcycles, pedestrians,
/// signs on poles) on its lanes and pavements, seen from a car. All parts are convex, and rays are met analytically.
/// </summary>
internal sealed class TownScene : IRayCaster
{
    /// <summary>The seed of scene 0.</summary>
    private const int FirstSeed = 1000;

    private readonly List<SolidThing> _things = [];

    public TownScene(int seed, int objects, ImageSize image)
    {
        var random = new Random(seed);
        var pose = new Pose(
            new(random.Between(-3, 3), 0, random.Between(1.2, 2.2)),
            Axes.FromEuler(new EulerAngles(random.Between(-4, 2), random.Between(-2, 2), random.Between(-12, 12)))
        );
        Camera = new Camera(pose, new CameraIntrinsics(50, image, image.Aspect, 0.1, Lens.Ideal));
        BuildStreet(random);
        int entity = 1;
        while (entity <= objects)
        {
            SolidThing thing = TownTraffic.Draw(random, entity);
            if (CuboidProjector.Project(Camera, thing.Bounds).Outcome == BoxOutcome.InImage)
            {
                _things.Add(thing);
                entity++;
            }
        }
    }

    public Camera Camera { get; }

    private IEnumerable<SolidThing> Entities => _things.Where(thing => thing.Entity != RayHit.World);

    /// <summary>The scenes that issue and documentation speak of: 5 to 80 objects.</summary>
    public static TownScene Numbered(int number, ImageSize image) => new(FirstSeed + number, ObjectsOf(number), image);

    /// <summary>How many objects a numbered scene has: 5 in scene 0, 80 in scene 49.</summary>
    public static int ObjectsOf(int number) => 5 + (number * 75 / 49);

    public List<MapTarget> Targets() =>
        [
            .. Entities.Select(thing => new MapTarget(
                thing.Entity,
                (ushort)thing.Entity,
                thing.Bounds,
                CuboidProjector.Project(Camera, thing.Bounds)
            )),
        ];

    /// <summary>
    /// The map of <see cref="ExhaustivePixelMapper"/> over the whole image, sooner: no entity reaches out of its cuboid, so each row is
    /// asked only where a cuboid's box is, and the rows are asked by all processors.
    /// </summary>
    public InstanceMap ExhaustiveMap()
    {
        var map = new InstanceMap(Camera.Image);
        Box2D[] boxes = [.. Targets().Select(target => target.Projection.Box).OfType<Box2D>()];
        Parallel.For(
            0,
            Camera.Image.Height,
            row =>
            {
                double asked = 0;
                foreach (Box2D box in boxes.Where(box => box.YMin <= row + 0.5 && row + 0.5 <= box.YMax).OrderBy(box => box.XMin))
                {
                    if (box.XMax > asked)
                    {
                        var part = new Box2D(Math.Max(asked, box.XMin), row, box.XMax, row + 1);
                        ExhaustivePixelMapper.MapInto(map, Camera, part, entity => (ushort)entity, RayHit.World, this);
                        asked = box.XMax;
                    }
                }
            }
        );
        return map;
    }

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        double nearest = maxDistance;
        int entity = -1;
        if (ray.Direction.Z < 0 && -ray.Origin.Z / ray.Direction.Z is var ground && ground <= nearest)
        {
            nearest = ground;
            entity = RayHit.World;
        }

        foreach (SolidThing thing in _things)
        {
            if (
                (thing.Entity == ignoredEntity && ignoredEntity != RayHit.World)
                || thing.Bounds.Intersect(ray) is not { } span
                || span.Entry > nearest
            )
            {
                continue;
            }

            foreach (ConvexSolid part in thing.Parts)
            {
                if (part.Enter(ray) is { } distance && distance < nearest)
                {
                    nearest = distance;
                    entity = thing.Entity;
                }
            }
        }

        return entity < 0 ? null : new RayHit(nearest, entity);
    }

    private void BuildStreet(Random random)
    {
        for (double y = 10; y < 160; y += random.Between(14, 30))
        {
            foreach (int side in (int[])[-1, 1])
            {
                var pose = new Pose(new(side * random.Between(17, 20), y, 0), Axes.FromHeading(0));
                AddWorld(pose, (new(-5, 0, 0), new(5, random.Between(8, 14), random.Between(5, 16)), 1, 1));
                var post = new Pose(new(side * random.Between(7.2, 7.8), y + random.Between(0, 8), 0), Axes.Identity);
                AddWorld(
                    post,
                    (new(-0.1, -0.1, 0), new(0.1, 0.1, 7), 0.7, 0.7),
                    side > 0 ? (new(-1.6, -0.1, 6.8), new(0, 0.1, 7), 1, 1) : (new(0, -0.1, 6.8), new(1.6, 0.1, 7), 1, 1)
                );
                if (random.NextDouble() < 0.4)
                {
                    var tree = new Pose(
                        new(side * random.Between(8.5, 10.5), y + random.Between(0, 8), 0),
                        Axes.FromHeading(random.Between(0, 90))
                    );
                    AddWorld(tree, (new(-0.2, -0.2, 0), new(0.2, 0.2, 3), 1, 1), (new(-1.5, -1.5, 2.2), new(1.5, 1.5, 6), 0.4, 0.4));
                }
            }
        }

        AddWorld(new Pose(new(0, 180, 0), Axes.Identity), (new(-60, 0, 0), new(60, 10, 20), 1, 1));
    }

    private void AddWorld(Pose pose, params (Vector3D Min, Vector3D Max, double TopWidth, double TopLength)[] parts) =>
        _things.Add(SolidThing.Build(RayHit.World, pose, parts));
}
