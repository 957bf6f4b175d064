using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Models;

public sealed class ModelCatalogueTests
{
    /// <summary>Rounding of the sums that build a mesh from fractions of its box.</summary>
    private const double Rounding = 1e-12;

    internal static readonly ModelCatalogue Catalogue = ModelCatalogue.Shared;

    [Fact]
    public void Vehicles_are_the_games_models_of_every_class()
    {
        Assert.Equal(63, Catalogue.Vehicles.Count);
        ObjectClass[] classes =
        [
            ObjectClass.Car,
            ObjectClass.Truck,
            ObjectClass.Bus,
            ObjectClass.Motorcycle,
            ObjectClass.Bicycle,
            ObjectClass.Trailer,
            ObjectClass.Other,
        ];
        Assert.All(classes, expected => Assert.Contains(Catalogue.Vehicles, model => model.Class == expected));

        // The published size of one of them.
        Assert.Equal(new Vector3D(-0.931507, -2.260325, -0.39507), Catalogue["asea"].Min);
        Assert.Equal(new Vector3D(0.931507, 2.080368, 0.943845), Catalogue["asea"].Max);
    }

    [Fact]
    public void Every_vehicle_mesh_touches_all_six_sides_of_its_models_box()
    {
        foreach (Model model in Catalogue.Vehicles)
        {
            foreach (Mesh mesh in model.Variants)
            {
                AssertClose(model.Min, mesh.Min, model.Name);
                AssertClose(model.Max, mesh.Max, model.Name);
            }
        }
    }

    [Fact]
    public void Every_other_model_has_the_box_around_all_its_variants()
    {
        IEnumerable<Model> models =
        [
            .. Catalogue.Pedestrians,
            .. Catalogue.Signs,
            .. Catalogue.TrafficLights,
            .. Catalogue.Trees,
            Catalogue.StreetLamp,
        ];
        foreach (Model model in models)
        {
            Assert.Equal(
                model.Min,
                new Vector3D(model.Variants.Min(m => m.Min.X), model.Variants.Min(m => m.Min.Y), model.Variants.Min(m => m.Min.Z))
            );
            Assert.Equal(
                model.Max,
                new Vector3D(model.Variants.Max(m => m.Max.X), model.Variants.Max(m => m.Max.Y), model.Variants.Max(m => m.Max.Z))
            );
        }
    }

    [Fact]
    public void Pedestrians_have_the_height_of_people()
    {
        Assert.All(Catalogue.Pedestrians, model => Assert.InRange(model.Max.Z - model.Min.Z, 1.55, 2));
    }

    [Fact]
    public void Traffic_lights_have_a_variant_for_each_state()
    {
        Assert.All(Catalogue.TrafficLights, model => Assert.Equal(Enum.GetValues<SignalState>().Length, model.Variants.Count));
        Model light = Catalogue["prop_traffic_03a"];
        Rgb[] burning = light.Variants.Select(mesh => mesh.Triangles.ToArray().First(t => t.Surface == Surface.Lamp).Colour).ToArray();
        Assert.True(burning[(int)SignalState.Red].Red > burning[(int)SignalState.Red].Green);
        Assert.True(burning[(int)SignalState.Green].Green > burning[(int)SignalState.Green].Red);
    }

    [Fact]
    public void Variant_wraps_around_for_any_number()
    {
        Model car = Catalogue["asea"];
        Assert.Same(car.Variant(0), car.Variant(car.Variants.Count));
        Assert.NotNull(car.Variant(-7));
        Assert.True(car.Variants.Count > 5);
    }

    [Fact]
    public void Unknown_name_is_refused_with_the_name()
    {
        KeyNotFoundException error = Assert.Throws<KeyNotFoundException>(() => Catalogue["no_such_car"]);
        Assert.Contains("no_such_car", error.Message, StringComparison.Ordinal);
    }

    private static void AssertClose(Vector3D expected, Vector3D actual, string name) =>
        Assert.True((expected - actual).Length <= Rounding, $"{name}: {actual} instead of {expected}");
}
