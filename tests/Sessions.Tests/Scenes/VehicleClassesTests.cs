using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Tests.Scenes;

public sealed class VehicleClassesTests
{
    // The game's classes: 1 sedans, 8 motorcycles, 10 industrial, 11 utility, 12 vans, 13 cycles, 14 boats, 17 service, 18 emergency, 20
    // commercial.
    [Theory]
    [InlineData("adder", 7, ObjectClass.Car)]
    [InlineData("taxi", 17, ObjectClass.Car)]
    [InlineData("bus", 17, ObjectClass.Bus)]
    [InlineData("pbus", 18, ObjectClass.Bus)]
    [InlineData("firetruk", 18, ObjectClass.Truck)]
    [InlineData("police3", 18, ObjectClass.Car)]
    [InlineData("policeb", 18, ObjectClass.Motorcycle)]
    [InlineData("akuma", 8, ObjectClass.Motorcycle)]
    [InlineData("bmx", 13, ObjectClass.Bicycle)]
    [InlineData("hauler", 20, ObjectClass.Truck)]
    [InlineData("biff", 10, ObjectClass.Truck)]
    [InlineData("trailers", 11, ObjectClass.Trailer)]
    [InlineData("dinghy", 14, ObjectClass.Other)]
    public void Kind_follows_the_model_and_then_the_games_class(string model, int gameClass, ObjectClass expected)
    {
        Assert.Equal(expected, VehicleClasses.Of(ModelHash.Of(model), gameClass));
    }

    [Fact]
    public void Every_class_that_has_riders_is_a_vehicle()
    {
        ObjectClass[] ridden = [.. Enum.GetValues<ObjectClass>().Where(VehicleClasses.HaveRiders)];

        Assert.Equal([ObjectClass.Motorcycle, ObjectClass.Bicycle], ridden);
        Assert.All(ridden, kind => Assert.True(VehicleClasses.AreVehicles(kind)));
    }

    [Theory]
    [InlineData(ObjectClass.Trailer, true)]
    [InlineData(ObjectClass.Pedestrian, false)]
    [InlineData(ObjectClass.Sign, false)]
    [InlineData(ObjectClass.Other, false)]
    public void Vehicles_are_what_drives_on_the_road(ObjectClass kind, bool expected) =>
        Assert.Equal(expected, VehicleClasses.AreVehicles(kind));
}
