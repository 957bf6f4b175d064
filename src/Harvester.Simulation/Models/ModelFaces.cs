using Harvester.Geometry;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Models;

/// <summary>The faces and heads of the simulated game's signs and traffic lights, computed from their shapes.</summary>
public static class ModelFaces
{
    private const string Source = "the simulated game's own shapes";

    private static readonly Dictionary<string, (string Name, string MutcdCode)> Signs = new()
    {
        ["prop_sign_road_01a"] = ("STOP", "R1-1"),
        ["prop_sign_road_02a"] = ("YIELD", "R1-2"),
        ["prop_sign_road_03a"] = ("DO NOT ENTER", "R5-1"),
        ["prop_sign_road_03e"] = ("DO NOT BLOCK INTERSECTION", "R10-7"),
        ["prop_sign_road_03m"] = ("NO U-TURN", "R3-4"),
        ["prop_sign_road_04a"] = ("NO PARKING ANY TIME", "R7-1"),
        ["prop_sign_road_05a"] = ("PEDESTRIAN", "W11-2"),
        ["prop_sign_road_05e"] = ("LEFT TURN", "W1-1L"),
        ["prop_sign_road_05f"] = ("RIGHT TURN", "W1-1R"),
        ["prop_sign_road_06a"] = ("SPEED LIMIT 15", "R2-1"),
        ["prop_sign_road_06b"] = ("SPEED LIMIT 5", "R2-1"),
        ["prop_sign_road_06d"] = ("SPEED LIMIT 25", "R2-1"),
        ["prop_sign_road_06e"] = ("SPEED LIMIT 35", "R2-1"),
        ["prop_sign_road_06f"] = ("SPEED LIMIT 50", "R2-1"),
        ["prop_sign_road_06g"] = ("SPEED LIMIT 60", "R2-1"),
        ["prop_sign_road_06j"] = ("SPEED LIMIT 55", "R2-1"),
    };

    private static readonly Lazy<FaceTable> LazyTable = new(() =>
        new FaceTable([.. SignModels.All().Select(FaceOf), .. SignalModels.All().SelectMany(HeadsOf)])
    );

    /// <summary>The table of all of them. Its corners are derived from the shapes, not measured.</summary>
    public static FaceTable Table => LazyTable.Value;

    private static ModelFace FaceOf(Model sign)
    {
        (string name, string code) = Signs[sign.Name];
        return FaceOf(sign, name, code, 0, SignModels.Face(sign));
    }

    private static IEnumerable<ModelFace> HeadsOf(Model light) =>
        SignalModels.Heads(light.Name).Select((box, number) => FaceOf(light, "TRAFFIC LIGHT", string.Empty, number, box));

    private static ModelFace FaceOf(Model model, string name, string code, int face, (Vector3D Min, Vector3D Max) box) =>
        new(
            model.Name,
            ModelHash.Of(model.Name),
            model.Class,
            name,
            code,
            face,
            new Vector3D(box.Min.X, box.Max.Y, box.Max.Z),
            new Vector3D(box.Max.X, box.Min.Y, box.Min.Z),
            Facing.Back,
            Provenance.Derived,
            Source
        );
}
