namespace Harvester.Capture.Harvesting;

/// <summary>What is to be done with the next frame, or with the first of the views of the next moment.</summary>
/// <param name="Number">Its number in the session.</param>
/// <param name="Before">Number of the frame of the same view before it at the same place; null for the first.</param>
/// <param name="IsOurs">
/// Whether it is taken. One of another shard, or one that the session already holds, is read and settled too, but not handed over.
/// </param>
/// <param name="IsLabelled">
/// Whether it is labelled: if it is taken, and if it is not but the next one is and has a channel that continues from the frame before.
/// </param>
internal readonly record struct FrameTurn(int Number, int? Before, bool IsOurs, bool IsLabelled)
{
    /// <summary>The same for another view of the moment, by its index.</summary>
    public FrameTurn OfView(int index) => this with { Number = Number + index, Before = Before + index };
}
