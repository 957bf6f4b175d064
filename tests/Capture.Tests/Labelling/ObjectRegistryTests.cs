using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Labelling;

public sealed class ObjectRegistryTests
{
    private static readonly EntityState Car = new(
        10,
        ObjectClass.Car,
        "asea",
        new Pose(Vector3D.Zero, Axes.Identity),
        new Vector3D(-1, -2, 0),
        new Vector3D(1, 2, 1.5),
        Vector3D.Zero
    );

    [Fact]
    public void IdOf_an_entity_that_moved_is_the_same()
    {
        var registry = new ObjectRegistry(1);

        Assert.Equal(1, registry.IdOf(Car));
        Assert.Equal(2, registry.IdOf(Car with { Handle = 11 }));
        Assert.Equal(1, registry.IdOf(Car with { Pose = new Pose(new Vector3D(5, 0, 0), Axes.Identity) }));
    }

    [Fact]
    public void IdOf_handle_given_to_another_model_or_class_is_a_new_object()
    {
        var registry = new ObjectRegistry(1);
        registry.IdOf(Car);

        Assert.Equal(2, registry.IdOf(Car with { Model = "blista" }));
        Assert.Equal(3, registry.IdOf(Car with { Model = "blista", Class = ObjectClass.Other }));

        // Back to the first model: the first object has gone, this is a third one.
        Assert.Equal(4, registry.IdOf(Car));
    }

    [Fact]
    public void IdOf_uses_recorded_ids_and_numbers_new_objects_after_them()
    {
        var ids = new RecordedIds();
        ids.Add(SceneOf(Car with { Handle = 12 }, 3));
        ids.Add(SceneOf(Car, 7));
        var registry = new ObjectRegistry(ids.Greatest + 1) { Recorded = ids };

        Assert.Equal(7, registry.IdOf(Car));
        Assert.Equal(8, registry.IdOf(Car with { Handle = 11 }));
        Assert.Equal(3, registry.IdOf(Car with { Handle = 12 }));
        Assert.Equal(9, registry.IdOf(Car, face: 0));
    }

    [Fact]
    public void Remember_prefers_the_ids_of_the_latest_scene()
    {
        // The handle was reused for another car of the same model, to which a resumed harvest gave a new id.
        var registry = new ObjectRegistry(20);
        registry.Remember(SceneOf(Car, 4));
        registry.Remember(SceneOf(Car, 9));

        Assert.Equal(9, registry.IdOf(Car));
        Assert.Equal(20, registry.IdOf(Car with { Handle = 11 }));
    }

    private static RecordedScene SceneOf(EntityState entity, int id) =>
        new(
            new SceneSnapshot(
                0,
                0,
                new CameraState(entity.Pose, 50, 0.1, 1),
                new EgoState(0, "", entity.Pose, Vector3D.Zero),
                [entity],
                new EnvironmentState("clear", TimeSpan.Zero)
            ),
            Lens.Ideal,
            new Dictionary<int, int> { [entity.Handle] = id },
            []
        );
}
