namespace Harvester.Capture.Ports;

/// <summary>Counts what was asked of the game since its start. Neither count ever falls.</summary>
public interface ICallCounter
{
    /// <summary>Calls of the game's native functions, those of rays included.</summary>
    long Natives { get; }

    /// <summary>Rays cast.</summary>
    long Rays { get; }
}
