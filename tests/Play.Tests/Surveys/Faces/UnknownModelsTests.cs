using Harvester.Geometry;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Tests.Surveys.Faces;

public sealed class UnknownModelsTests
{
    [Fact]
    public void Write_lists_signs_and_lights_that_the_table_lacks_once_each()
    {
        FaceTable table = FaceTableReader
            .Read(new StringReader("prop_sign_road_01a,,sign,STOP,R1-1,0,-0.4,0,2.7,0.4,-0.1,1.9,-y,measured,test"))
            .Table;
        var unknown = new UnknownModels(() => table);

        unknown.Look([
            Entity("prop_traffic_01a", ObjectClass.TrafficLight, 3),
            Entity("prop_sign_road_01a", ObjectClass.Sign, 4),
            Entity("0xC76BD3AB", ObjectClass.Sign, 5), // the hash of prop_sign_road_01a
            Entity("blista", ObjectClass.Car, 6),
            Entity("0x00000010", ObjectClass.Sign, 7),
        ]);
        unknown.Look([Entity("prop_traffic_01a", ObjectClass.TrafficLight, 8)]);
        var text = new StringWriter();
        unknown.Write(text);

        Assert.Equal(
            $"model,hash,class,x,y,z\n0x00000010,16,sign,7,0.5,0\n"
                + $"prop_traffic_01a,{ModelHash.Of("prop_traffic_01a")},trafficLight,3,0.5,0\n",
            text.ToString()
        );
    }

    private static EntityState Entity(string model, ObjectClass kind, double x) =>
        new(1, kind, model, new Pose(new Vector3D(x, 0.5, 0), Axes.Identity), Vector3D.Zero, Vector3D.Zero, Vector3D.Zero);
}
