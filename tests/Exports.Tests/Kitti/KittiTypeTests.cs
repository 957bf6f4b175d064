using System.Text.Json.Nodes;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Tests.Kitti;

public sealed class KittiTypeTests : ExportTests
{
    [Theory]
    [InlineData("car", "blista", null, "Car")]
    [InlineData("car", "speedo", null, "Van")]
    [InlineData("car", "0xCFB3870C", null, "Van")]
    [InlineData("truck", "mule", null, "Truck")]
    [InlineData("bus", "bus", null, "Misc")]
    [InlineData("motorcycle", "bati", true, "Misc")]
    [InlineData("bicycle", "bmx", true, "Cyclist")]
    [InlineData("bicycle", "bmx", false, "Misc")]
    [InlineData("bicycle", "bmx", null, "Misc")]
    public void Type_follows_class_model_and_rider(string kind, string model, bool? hasRider, string expected) =>
        Assert.Equal(expected, TypeOf(kind, model, hasRider, new ExportOptions()));

    [Theory]
    [InlineData("bus", "bus", "Truck")]
    [InlineData("bicycle", "bmx", "Cyclist")]
    [InlineData("car", "speedo", "Car")]
    public void Type_is_the_requested_one(string kind, string model, string expected)
    {
        var names = new Dictionary<ObjectClass, string>
        {
            [ObjectClass.Bus] = "Truck",
            [ObjectClass.Bicycle] = "Cyclist",
            [ObjectClass.Car] = "Car",
        };

        Assert.Equal(expected, TypeOf(kind, model, null, new ExportOptions { Names = names }));
    }

    private string TypeOf(string kind, string model, bool? hasRider, ExportOptions options)
    {
        JsonObject car = Session.Car(0);
        (car["class"], car["model"], car["hasRider"]) = (kind, model, hasRider);
        Folder.Export("kitti", Session.Open(), options);
        return Folder.Lines("out/training/label_2/000000.txt")[0].Split(' ')[0];
    }
}
