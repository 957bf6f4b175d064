using System.Text.Json.Nodes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Masks;

/// <summary>A session and the maps of another tool for its frames: a pedestrian before the right half of a car.</summary>
public abstract class MapsOfAnotherTool : IDisposable
{
    protected const ushort Car = 1;
    protected const ushort Pedestrian = 2;
    protected const ushort Sign = 3;
    protected const ushort Face = 4;

    private protected TestSession Session { get; } = new();
    protected string Maps { get; } = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    protected MapsOfAnotherTool()
    {
        // The pedestrian steps before the right half of the car: 0 to 1 m right at 5 m is columns 40 to 45, ±1 m is rows 24 to 35.
        foreach (JsonObject line in Session.Lines)
        {
            JsonObject pedestrian = line["objects"]![1]!.AsObject();
            pedestrian["box3d"]!["centre"] = new JsonArray(0.5, 5, 0);
            pedestrian["box3d"]!["halfExtents"] = new JsonArray(0.5, 0, 1);
            pedestrian["box2d"] = new JsonArray(40, 24, 46, 36);
            pedestrian["box2dAmodal"] = new JsonArray(40, 24, 46, 36);
            pedestrian["truncatedFraction"] = 0;
            pedestrian["distanceMetres"] = 5.0249;
        }

        for (int frame = 0; frame < 3; frame++)
        {
            WriteMap($"{frame}.png", Scene(Car, Pedestrian));
        }
    }

    public void Dispose()
    {
        Session.Dispose();
        Directory.Delete(Maps, recursive: true);
        GC.SuppressFinalize(this);
    }

    // The car's near face is 6 x 6 pixels around (40, 30).
    private protected static InstanceMap Scene(ushort car, ushort pedestrian)
    {
        var map = new InstanceMap(new ImageSize(TestSession.Width, TestSession.Height));
        Fill(map, car, 37, 27, 43, 33);
        Fill(map, pedestrian, 40, 24, 46, 36);
        return map;
    }

    private protected static void Fill(InstanceMap map, ushort number, int left, int top, int right, int bottom)
    {
        for (int row = top; row < bottom; row++)
        {
            for (int column = left; column < right; column++)
            {
                map[column, row] = number;
            }
        }
    }

    private protected InstanceMap MaskOf(FrameLabel label) => PngDecoder.ReadInstanceMap(Session.PathOf(label.Mask!));

    private protected void WriteMap(string name, InstanceMap map)
    {
        using FileStream file = File.Create(Path.Combine(Maps, name));
        new PngEncoder().Write(map, file);
    }
}
