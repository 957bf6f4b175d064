using GTA.Math;

namespace GTA.Hosting;

/// <summary>The one seam behind the stand-in, implemented by a test's game.</summary>
internal interface IGameHost
{
    /// <summary>Full path of the script's dll.</summary>
    string ScriptFile { get; }

    /// <summary>Runs a native: reads its arguments from the call's slots and writes its result.</summary>
    void Call(NativeCall call);

    /// <summary>The handles of what lies within a radius of a point and, if models are named, has one of them.</summary>
    int[] HandlesNear(PoolKind pool, Vector3 position, float radius, int[] models);

    /// <summary>Shows a message to the player.</summary>
    void Notify(string message);

    /// <summary>Tells of a script's fault that the real game would not report but suffer from.</summary>
    void Report(string fault);
}
