using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>Leaves the world as it is: for a recording, whose end must not resume what a client has paused.</summary>
internal sealed class NoPause : IPause
{
    /// <inheritdoc/>
    public FreezeMethod Method { get; set; }

    /// <inheritdoc/>
    public void Freeze() { }

    /// <inheritdoc/>
    public void Unfreeze() { }
}
