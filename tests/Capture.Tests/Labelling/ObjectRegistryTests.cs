using Harvester.Capture.Labelling;
using Harvester.Capture.Scenes;
using Harvester.Geometry;

namespace Harvester.Capture.Tests.Labelling;

public sealed class ObjectRegistryTests
{
    private static readonly EntityState Car = new(
        10, ObjectClass.Car, "asea", new Pose(Vector3D.Zero, Axes.Identity), new Vector3D(-1, -2, 0), new Vector3D(1, 2, 1.5), Vector3D.Zero);

    [Fact]
    public void IdOf_same_entity_elsewhere_is_the_same()
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
}
