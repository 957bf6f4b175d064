using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>The game's models that are vans: its van class without pick-ups, and vans of other classes.</summary>
internal static class KittiVans
{
    private static readonly HashSet<int> Hashes =
    [
        .. (
            "ambulance boxville boxville2 boxville3 boxville4 boxville5 burrito burrito2 burrito3 burrito4 burrito5 camper gburrito "
            + "gburrito2 journey journey2 minivan minivan2 moonbeam moonbeam2 paradise policet pony pony2 rumpo rumpo2 rumpo3 "
            + "speedo speedo2 speedo3 speedo4 speedo5 surfer surfer2 surfer3 taco youga youga2 youga3 youga4 youga5"
        )
            .Split(' ')
            .Select(ModelHash.Of),
    ];

    /// <summary>Whether a model is a van.</summary>
    /// <param name="model">Name of the model, or its hash as 0xXXXXXXXX.</param>
    public static bool Has(string model) => Hashes.Contains(ModelHash.TryParse(model, out int hash) ? hash : ModelHash.Of(model));
}
