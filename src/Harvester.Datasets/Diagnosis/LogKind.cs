namespace Harvester.Datasets.Diagnosis;

/// <summary>Who wrote a log, from the bottom up: each of them loads the next.</summary>
public enum LogKind
{
    /// <summary>ScriptHookV.log.</summary>
    ScriptHook,

    /// <summary>ScriptHookVDotNet.log.</summary>
    Loader,

    /// <summary>GtaDataHarvester.log, or what a session says of its harvest.</summary>
    Mod,
}
