namespace Harvester.Sessions.Labels;

/// <summary>Paths of the maps of dense motion within the session, with forward slashes.</summary>
/// <param name="Backward">Flow from the pixels of the frame to the frame before.</param>
/// <param name="Forward">Flow from the pixels of the frame before to the frame.</param>
/// <param name="Motion">Motion of the surfaces in the world, of the pixels of the frame.</param>
/// <param name="BackwardFlags">What is known of each pixel of the frame.</param>
/// <param name="ForwardFlags">What is known of each pixel of the frame before.</param>
public sealed record FlowFiles(string Backward, string Forward, string Motion, string BackwardFlags, string ForwardFlags)
{
    /// <summary>All paths.</summary>
    public IEnumerable<string> All => [Backward, Forward, Motion, BackwardFlags, ForwardFlags];
}
