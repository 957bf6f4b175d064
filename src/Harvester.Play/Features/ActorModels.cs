using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>The game's models of staged actors: by their name, or by that of a class, of which the actor's number chooses one.</summary>
internal static class ActorModels
{
    /// <summary>Who drives.</summary>
    public const string Driver = "a_m_y_business_01";

    private static readonly Dictionary<string, string[]> Classes = new(StringComparer.Ordinal)
    {
        ["car"] = ["asea", "asterope", "fugitive", "premier", "primo", "stanier", "surge", "oracle", "blista", "landstalker"],
        ["van"] = ["speedo", "pony"],
        ["truck"] = ["biff", "stockade", "packer"],
        ["lorry"] = ["boxville", "stockade"],
        ["bus"] = ["pbus"],
        ["motorcycle"] = ["akuma", "bati"],
        ["bicycle"] = ["scorcher", "bmx"],
        ["police"] = ["police2", "police3"],
        ["fireEngine"] = ["firetruk"],
        ["pedestrian"] = ["a_m_y_business_01", "a_f_y_business_01", "a_m_m_skater_01", "a_f_m_tourist_01"],
        ["cone"] = ["prop_roadcone02a"],
        ["barrier"] = ["prop_barrier_work05"],
        ["crate"] = ["prop_box_wood05a"],
        ["dog"] = ["a_c_retriever"],
        ["deer"] = ["a_c_deer"],
        ["cow"] = ["a_c_cow"],
    };

    /// <summary>The name of an actor's model.</summary>
    public static string NameOf(StageActor actor) =>
        Classes.TryGetValue(actor.Model, out string[]? names) ? names[(actor.Number & int.MaxValue) % names.Length] : actor.Model;
}
