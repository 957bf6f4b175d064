using Harvester.Geometry.Work;

namespace Harvester.Capture.Harvesting;

/// <summary>Decides when a harvest takes a frame, and how many.</summary>
internal interface IFrameTrigger
{
    /// <summary>Whether the last <see cref="Await"/> ended with a frame to be taken; false at the end of the harvest.</summary>
    bool IsFrameDue { get; }

    /// <summary>Waits until a frame is to be taken, or none any more.</summary>
    IEnumerable<WorkStep> Await();

    /// <summary>Called after a frame was taken or discarded.</summary>
    void Leave();
}
