using System.Reflection;

namespace Harvester.Play.Tests.Setup;

/// <summary>A port of a game in which nothing happens. Members return their defaults, or what the test gives for their names.</summary>
public class IdlePort : DispatchProxy
{
    private List<string> _calls = [];
    private IReadOnlyDictionary<string, object> _answers = new Dictionary<string, object>();

    /// <summary>Makes a port.</summary>
    /// <param name="calls">Receives the names of the called members.</param>
    /// <param name="answers">Results by the name of the member.</param>
    public static T Of<T>(List<string> calls, IReadOnlyDictionary<string, object> answers)
        where T : class
    {
        T port = Create<T, IdlePort>();
        var proxy = (IdlePort)(object)port;
        proxy._calls = calls;
        proxy._answers = answers;
        return port;
    }

    protected override object? Invoke(MethodInfo? targetMethod, object?[]? args)
    {
        Type result = targetMethod!.ReturnType;
        string name = targetMethod.Name.Replace("get_", string.Empty, StringComparison.Ordinal);
        _calls.Add(name);
        return _answers.TryGetValue(name, out object? answer) ? answer
            : result.IsValueType && result != typeof(void) ? Activator.CreateInstance(result)
            : null;
    }
}
