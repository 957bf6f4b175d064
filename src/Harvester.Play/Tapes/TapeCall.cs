namespace Harvester.Play.Tapes;

/// <summary>A call to the game and its answer.</summary>
/// <param name="Target">Hash of the native, or one of the lists of <see cref="TapeLists"/>.</param>
/// <param name="Asked">The arguments.</param>
/// <param name="Answer">The result; a failure if the call failed.</param>
/// <param name="Written">What the memory among the arguments holds after the call, one int per slot, without zeros at the end.</param>
public sealed record TapeCall(ulong Target, IReadOnlyList<TapeValue> Asked, TapeValue Answer, IReadOnlyList<IReadOnlyList<int>> Written)
    : TapeEntry;
