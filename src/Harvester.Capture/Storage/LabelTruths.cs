namespace Harvester.Capture.Storage;

/// <summary>Which labels of a session are exact and which are estimated, by name: the field <c>truth</c> of session.json.</summary>
public static class LabelTruths
{
    /// <summary>Those of GTA V.</summary>
    public static IReadOnlyList<KeyValuePair<string, LabelTruth>> OfGame { get; } =
    [
        new("camera", LabelTruth.Estimated),
        new("cuboids", LabelTruth.Exact),
        new("occlusion", LabelTruth.Estimated),
        new("trueOcclusion", LabelTruth.Unknown),
        new("masks", LabelTruth.Estimated),
        new("joints", LabelTruth.Estimated),
        new("jointVisibility", LabelTruth.Estimated),
        new("trafficLights", LabelTruth.Estimated),
        new("vehicleLights", LabelTruth.Unknown),
        new("lanes", LabelTruth.Estimated),
        new("markings", LabelTruth.Unknown),
        new("egoMotion", LabelTruth.Unknown),
    ];

    /// <summary>Those of a simulated game.</summary>
    /// <param name="hasTrueOcclusion">Whether the renderer reports how much of each object is hidden.</param>
    public static IReadOnlyList<KeyValuePair<string, LabelTruth>> OfSimulation(bool hasTrueOcclusion) =>
        [
            new("camera", LabelTruth.Exact),
            new("cuboids", LabelTruth.Exact),
            new("occlusion", LabelTruth.Estimated),
            new("trueOcclusion", hasTrueOcclusion ? LabelTruth.Exact : LabelTruth.Unknown),
            new("masks", LabelTruth.Estimated),
            new("joints", LabelTruth.Exact),
            new("jointVisibility", LabelTruth.Estimated),
            new("trafficLights", LabelTruth.Exact),
            new("vehicleLights", LabelTruth.Exact),
            new("lanes", LabelTruth.Estimated),
            new("markings", LabelTruth.Exact),
            new("egoMotion", LabelTruth.Exact),
        ];
}
