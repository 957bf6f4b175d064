using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Mod;
using Harvester.Play.Tapes;

namespace Harvester.Tapes;

/// <summary>Answers the mod's calls to the game from a tape.</summary>
/// <param name="tape">The tape.</param>
internal sealed class PlayedApi(TapeCursor tape) : IGameApi
{
    /// <summary>The longest list of arguments in a message.</summary>
    private const int MaxDescribed = 12;

    /// <inheritdoc/>
    public T Call<T>(Hash native, NativeArgument[] arguments)
    {
        if (TapedCall.IsLeftOut(native))
        {
            return default!;
        }

        TapeCall call = Answer((ulong)native, [.. arguments.Select(argument => argument.Recorded)]);
        Fill(call, arguments);
        return (T)(
            TapedCall.Result(typeof(T), call.Answer)
            ?? throw tape.Differ($"{native} with a result of another type", $"{native} with a result of type {typeof(T).Name}")
        );
    }

    /// <inheritdoc/>
    public void Call(Hash native, NativeArgument[] arguments)
    {
        if (!TapedCall.IsLeftOut(native))
        {
            Fill(Answer((ulong)native, [.. arguments.Select(argument => argument.Recorded)]), arguments);
        }
    }

    /// <inheritdoc/>
    public int[] Nearby(EntityKind kind, Vector3D centre, double radius, IReadOnlyList<int> models)
    {
        IReadOnlyList<IReadOnlyList<int>> written = Answer(TapedCall.TargetOf(kind), TapedCall.Asked(centre, radius, models)).Written;
        return written.Count > 0 ? [.. written[0]] : [];
    }

    /// <summary>A call as text.</summary>
    public static string Describe(ulong target, IReadOnlyList<TapeValue> asked)
    {
        string name = target switch
        {
            TapeLists.Vehicles => "the list of vehicles",
            TapeLists.Peds => "the list of peds",
            TapeLists.Props => "the list of props",
            _ => ((Hash)target).ToString(),
        };
        return $"{name}({string.Join(", ", asked.Take(MaxDescribed))}{(asked.Count > MaxDescribed ? ", ..." : "")})";
    }

    private TapeCall Answer(ulong target, TapeValue[] asked)
    {
        TapeCall call = tape.Take<TapeCall>(
            taped =>
                taped.Target == target
                && taped.Asked.Count == asked.Length
                && taped.Asked.Zip(asked).All(pair => pair.First.IsSameAs(pair.Second)),
            () => Describe(target, asked)
        );
        return call.Answer.Kind switch
        {
            TapeValueKind.InvalidOperation => throw new InvalidOperationException("The call failed when the tape was recorded."),
            TapeValueKind.Failure => throw new NotSupportedException("The call failed when the tape was recorded."),
            _ => call,
        };
    }

    private static void Fill(TapeCall call, NativeArgument[] arguments)
    {
        int next = 0;
        foreach (NativeArgument argument in arguments)
        {
            if (argument.Output is { } output && next < call.Written.Count)
            {
                output.Fill(call.Written[next++]);
            }
        }
    }
}
