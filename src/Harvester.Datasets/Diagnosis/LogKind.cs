namespace Harvester.Datasets.Diagnosis;

/// <summary>The program that wrote a log, from the lowest layer up: each loads the next.</summary>
public enum LogKind
{
    /// <summary>ScriptHookV.log.</summary>
    ScriptHook,

    /// <summary>ScriptHookVDotNet.log.</summary>
    Loader,

    /// <summary>GtaDataHarvester.log, or session.json.</summary>
    Mod,
}
